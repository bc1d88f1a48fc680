# The dependencies of sbgc::io: Asio without Boost, as the target sbgc::asio, and libserialport, as
# the target PkgConfig::sbgc_serialport. Sets sbgc_io_missing to the ones not found. Used by the
# build and by an installed sbgc.

set(sbgc_io_missing "")
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads QUIET)
if(NOT Threads_FOUND)
  list(APPEND sbgc_io_missing "threads")
endif()

find_path(SBGC_ASIO_INCLUDE_DIR asio/any_io_executor.hpp DOC "The folder of Asio's headers")
mark_as_advanced(SBGC_ASIO_INCLUDE_DIR)
if(NOT SBGC_ASIO_INCLUDE_DIR)
  list(APPEND sbgc_io_missing "Asio (Debian: libasio-dev)")
elseif(Threads_FOUND AND NOT TARGET sbgc::asio)
  add_library(sbgc::asio INTERFACE IMPORTED)
  target_include_directories(sbgc::asio SYSTEM INTERFACE "${SBGC_ASIO_INCLUDE_DIR}")
  target_compile_definitions(sbgc::asio INTERFACE ASIO_STANDALONE ASIO_NO_DEPRECATED)
  target_link_libraries(sbgc::asio INTERFACE Threads::Threads)
endif()

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND AND NOT TARGET PkgConfig::sbgc_serialport)
  pkg_check_modules(sbgc_serialport QUIET IMPORTED_TARGET libserialport)
endif()
if(NOT TARGET PkgConfig::sbgc_serialport)
  list(APPEND sbgc_io_missing "libserialport (Debian: libserialport-dev, pkgconf)")
endif()
list(JOIN sbgc_io_missing ", " sbgc_io_missing)
