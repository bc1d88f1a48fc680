# sbgc_hardening: options that make errors in the sbgc command harder to exploit. Its libraries are built
# with them, too. Users of the library do not inherit them, and a subproject is built without them.

add_library(sbgc_hardening INTERFACE)
if(NOT PROJECT_IS_TOP_LEVEL OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux")
  return()
endif()

include(CheckCXXCompilerFlag)
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)

# Not every processor has them all; -Werror, because clang++ only warns. Without -fcf-protection:
# the linker drops its mark, and so its effect, because Debian's start files and libraries lack it.
foreach(flag IN ITEMS -fstack-protector-strong -fstack-clash-protection)
  string(MAKE_C_IDENTIFIER "sbgc_has${flag}" is_supported)
  set(CMAKE_REQUIRED_FLAGS -Werror)
  check_cxx_compiler_flag(${flag} ${is_supported})
  unset(CMAKE_REQUIRED_FLAGS)
  target_compile_options(sbgc_hardening INTERFACE $<$<BOOL:${${is_supported}}>:${flag}>)
endforeach()
target_link_options(sbgc_hardening INTERFACE LINKER:-z,relro,-z,now,-z,noexecstack)

# Needs optimization; the sanitizers have their own checks.
string(TOUPPER "CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}" flags)
if("${${flags}}" MATCHES "-O[1-3sz]" AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  # Some compilers define a lower level themselves. g++ has level 3 from version 12 on.
  set(level 3)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 12)
    set(level 2)
  endif()
  target_compile_options(sbgc_hardening INTERFACE -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=${level})
endif()
