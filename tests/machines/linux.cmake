# Cross compilation with a compiler of Debian.

# sbgc_cross_compile(<triplet> <emulator>)
macro(sbgc_cross_compile triplet emulator)
  set(CMAKE_SYSTEM_NAME Linux)
  string(REGEX MATCH "^[^-]+" CMAKE_SYSTEM_PROCESSOR "${triplet}")
  set(CMAKE_C_COMPILER ${triplet}-gcc)
  set(CMAKE_CXX_COMPILER ${triplet}-g++)
  # Remarks about old versions of the compiler.
  set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)
  set(CMAKE_CROSSCOMPILING_EMULATOR "${emulator};-L;/usr/${triplet}")
  set(CMAKE_FIND_ROOT_PATH "/usr/${triplet}")
  set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
endmacro()
