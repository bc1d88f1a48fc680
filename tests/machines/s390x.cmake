# Builds for s390x, a big-endian machine; qemu runs the programs.

include("${CMAKE_CURRENT_LIST_DIR}/linux.cmake")
sbgc_cross_compile(s390x-linux-gnu qemu-s390x)
