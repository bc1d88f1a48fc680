#include <sbgc/io/line.hpp>

namespace sbgc::io {

std::string to_string(const LineSettings& settings) {
  return std::to_string(settings.baud_rate) + (settings.parity == Parity::even ? " 8E1" : " 8N1");
}

}  // namespace sbgc::io
