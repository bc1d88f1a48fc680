# Debian packages: sbgc (the command), libsbgc-dev (the library) and python3-sbgc. `./dev package` makes them
# with the preset deb; SOURCE_DATE_EPOCH determines every time in them.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sbgc)
set(CPACK_PACKAGE_VENDOR "The sbgc authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # would precede those of the packages
# Debian requires an address; this one is reserved for examples.
set(CPACK_PACKAGE_CONTACT "The sbgc authors <sbgc@example.com>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 1) # xz in several threads depends on their number
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_SBGC_SOURCE_DIR "${PROJECT_SOURCE_DIR}")
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/finish.cmake")
set(CPACK_COMPONENTS_ALL command development)
# Header-only libraries become part of the compiled code; these licenses require a notice in copies.
set(CPACK_SBGC_NOTICES libcli11-dev libfmt-dev libkissfft-dev nlohmann-json3-dev)
if(TARGET sbgc_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  list(APPEND CPACK_SBGC_NOTICES pybind11-dev)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 0sbgc1) # older than 1, which would be Debian's own
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME sbgc)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION comm)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMMAND_DESCRIPTION
    "command for gimbals with the SimpleBGC serial protocol
Decodes and records the serial traffic of gimbal controllers by BaseCam
Electronics, reads and writes their parameters, turns the camera, and
emulates a gimbal for tests without hardware.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsbgc-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "pkgconf, cmake")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libc6-dev, libasio-dev, libserialport-dev, nlohmann-json3-dev (>= 3.11)")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "C++20 library for the SimpleBGC serial protocol
Messages, parser and session for gimbal controllers by BaseCam Electronics as
headers that need no operating system; clients for serial ports and sockets,
and an emulated gimbal, as static libraries.
.
Contains files for CMake and pkg-config.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-sbgc)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# The extension works with this version of Python only.
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11~), python3 (<< 3.12)")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/postinst"
                                              "${CMAKE_CURRENT_LIST_DIR}/prerm")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
    "Python package for the SimpleBGC serial protocol
A class for every message of gimbal controllers by BaseCam Electronics, a
client for gimbals that waits or works with asyncio, and an emulated gimbal
for tests without hardware.")

include(CPack)
