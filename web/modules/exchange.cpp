#include "modules/exchange.hpp"

#include <cstddef>

namespace sbgc::tools {

Exchange& exchange() {
  static Exchange result;
  return result;
}

}  // namespace sbgc::tools

using sbgc::tools::exchange;

/// Returns a buffer for the next `size` bytes of input.
SBGC_EXPORT(input) std::uint8_t* sbgc_input(std::size_t size) {
  exchange().input.resize(size);
  return exchange().input.data();
}

SBGC_EXPORT(output) const char* sbgc_output() { return exchange().output.data(); }
SBGC_EXPORT(output_size) std::size_t sbgc_output_size() { return exchange().output.size(); }
