/// The version of the library, and of the protocol that it implements.
///
/// The version is defined here and nowhere else: CMake and the generator read this file.
#pragma once

#include <sbgc/model.hpp>

#define SBGC_VERSION_MAJOR 0
#define SBGC_VERSION_MINOR 2
#define SBGC_VERSION_PATCH 0

/// The version as a number for comparisons: 10203 is 1.2.3.
#define SBGC_VERSION (SBGC_VERSION_MAJOR * 10000 + SBGC_VERSION_MINOR * 100 + SBGC_VERSION_PATCH)

#define SBGC_TEXT_OF(number) #number
#define SBGC_VERSION_TEXT_OF(major, minor, patch) \
  SBGC_TEXT_OF(major) "." SBGC_TEXT_OF(minor) "." SBGC_TEXT_OF(patch)
/// The version as a string literal: "1.2.3".
#define SBGC_VERSION_TEXT \
  SBGC_VERSION_TEXT_OF(SBGC_VERSION_MAJOR, SBGC_VERSION_MINOR, SBGC_VERSION_PATCH)
