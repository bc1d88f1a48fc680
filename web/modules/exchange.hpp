/// How a page and the module exchange texts and bytes: the page calls input() for a buffer, fills
/// it, calls a function, and reads output().
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#if defined(__wasm__)
#define SBGC_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#else  // for tools that only parse a file
#define SBGC_EXPORT(name) extern "C"
#endif

namespace sbgc::tools {

/// The buffers of the functions that a page calls, one at a time.
struct Exchange {
  std::vector<std::uint8_t> input;
  std::string output;
};

Exchange& exchange();

}  // namespace sbgc::tools
