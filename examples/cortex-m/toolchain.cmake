# Debian's g++ for Cortex-M: the packages gcc-arm-none-eabi and, for the headers of the freestanding C++
# library, libstdc++-arm-none-eabi-dev. Nothing of a C or C++ library is linked, except libgcc.
#
#   cmake -DCMAKE_TOOLCHAIN_FILE=.../toolchain.cmake -DCORTEX_M=m0plus|m4f|m7

set(CORTEX_M "m4f" CACHE STRING "The processor: m0plus, m4f or m7")
set(flags_m0plus "-mcpu=cortex-m0plus -mfloat-abi=soft")
set(flags_m4f "-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard")
set(flags_m7 "-mcpu=cortex-m7 -mfpu=fpv5-d16 -mfloat-abi=hard")
if(NOT DEFINED flags_${CORTEX_M})
  message(FATAL_ERROR "CORTEX_M is '${CORTEX_M}', not m0plus, m4f or m7")
endif()

set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
# The compiler's own test of itself would need a start-up and a linker script.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES CORTEX_M)

set(CMAKE_CXX_FLAGS_INIT
    "-mthumb ${flags_${CORTEX_M}} -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-unwind-tables -fno-asynchronous-unwind-tables -ffunction-sections -fdata-sections"
)
set(CMAKE_CXX_FLAGS_RELEASE "-Os -DNDEBUG")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -nostartfiles -Wl,--gc-sections")
# Libraries of this computer are of no use.
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
