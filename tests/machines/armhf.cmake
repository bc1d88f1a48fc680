# Builds for 32-bit ARM, where plain char is unsigned; qemu runs the programs.

include("${CMAKE_CURRENT_LIST_DIR}/linux.cmake")
sbgc_cross_compile(arm-linux-gnueabihf qemu-arm)
