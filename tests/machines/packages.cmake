# Packages for other machines: Debian has them only for this one. The headers of header-only packages
# fit any machine. They are linked into a folder of their own, because /usr/include also has the headers of
# this machine's C library. GoogleTest is built from source (package googletest).

macro(sbgc_provide_package method name)
  if("${name}" STREQUAL "fmt")
    sbgc_provide_headers(fmt::fmt fmt)
    target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY=1)
    set(fmt_FOUND TRUE)
  elseif("${name}" STREQUAL "nlohmann_json")
    sbgc_provide_headers(nlohmann_json::nlohmann_json nlohmann)
    set(nlohmann_json_FOUND TRUE)
  elseif("${name}" STREQUAL "CLI11")
    sbgc_provide_headers(CLI11::CLI11 CLI)
    set(CLI11_FOUND TRUE)
  elseif("${name}" STREQUAL "GTest")
    add_subdirectory(/usr/src/googletest "${CMAKE_BINARY_DIR}/googletest" EXCLUDE_FROM_ALL SYSTEM)
    set(GTest_FOUND TRUE)
  endif()
endmacro()

# sbgc_provide_headers(<target> <folder of /usr/include>)
function(sbgc_provide_headers target folder)
  if(TARGET ${target})
    return()
  endif()
  set(include "${CMAKE_BINARY_DIR}/packages/include")
  file(MAKE_DIRECTORY "${include}")
  file(CREATE_LINK "/usr/include/${folder}" "${include}/${folder}" SYMBOLIC)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${include}")
endfunction()

cmake_language(SET_DEPENDENCY_PROVIDER sbgc_provide_package SUPPORTED_METHODS FIND_PACKAGE)
