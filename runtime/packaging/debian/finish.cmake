# Runs in cpack when the files of each package are in its folder: adds the documents that Debian
# requires, and compresses the manual pages. All times are those of SOURCE_DATE_EPOCH.

cmake_policy(VERSION 3.25)
set(version "${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(maintainer "${CPACK_PACKAGE_CONTACT}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

# The license text in the format of Debian's copyright files.
file(READ "${CPACK_SBGC_SOURCE_DIR}/LICENSE" license)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]*)\n\n(.*)" license "${license}")
set(holder "${CMAKE_MATCH_1}")
string(STRIP "${CMAKE_MATCH_2}" license)
string(REPLACE "\n\n" "\n.\n" license "${license}")
string(REPLACE "\n" "\n " license " ${license}")

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER "${component}" name)
  set(package "${CPACK_DEBIAN_${name}_PACKAGE_NAME}")
  set(root "${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX}")
  set(documents "${root}/share/doc/${package}")
  configure_file("${CMAKE_CURRENT_LIST_DIR}/copyright.in" "${documents}/copyright" @ONLY
                 NO_SOURCE_PERMISSIONS)
  configure_file("${CMAKE_CURRENT_LIST_DIR}/changelog.in" "${documents}/changelog.Debian" @ONLY
                 NO_SOURCE_PERMISSIONS)
  foreach(library IN LISTS CPACK_SBGC_NOTICES)
    file(COPY_FILE "/usr/share/doc/${library}/copyright" "${documents}/copyright.${library}")
  endforeach()
  file(GLOB compressed "${documents}/changelog.Debian" "${root}/share/man/man1/*.1")
  execute_process(COMMAND gzip -9n ${compressed} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
