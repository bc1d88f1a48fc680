/// Between the core's line settings and those of serial ports.
#pragma once

#include <sbgc/io/line.hpp>
#include <sbgc/line.hpp>

namespace sbgc::detail {

constexpr LineSettings to_core(const io::LineSettings& line) noexcept {
  return {line.baud_rate, line.parity == io::Parity::even ? Parity::even : Parity::none};
}

constexpr io::LineSettings to_io(const LineSettings& line) noexcept {
  return {line.baud_rate, line.parity == Parity::even ? io::Parity::even : io::Parity::none};
}

}  // namespace sbgc::detail
