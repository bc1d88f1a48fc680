/// The line of a serial port: its settings, and control over them.
#pragma once

#include <string>

#include <sbgc/io/error.hpp>
#include <sbgc/line.hpp>
#include <sbgc/line_facts.hpp>

namespace sbgc::io {

using sbgc::default_line;
using sbgc::LineSettings;
using sbgc::Parity;

/// Formats line settings: "115200 8N1".
inline std::string to_string(const LineSettings& settings) {
  return std::to_string(settings.baud_rate) + (settings.parity == Parity::even ? " 8E1" : " 8N1");
}

/// Control over the line of a transport. Calls do not block.
class LineControl {
 public:
  LineControl() = default;
  LineControl(const LineControl&) = delete;
  LineControl& operator=(const LineControl&) = delete;
  virtual ~LineControl() = default;

  /// Changes the settings, reads them back and discards bytes received but not read. Bytes still
  /// being sent may be garbled. Returns Errc::line_refused if the port uses other settings than
  /// requested; they are then those of current().
  virtual Error set(const LineSettings& settings) = 0;

  /// Returns the current settings, as last read from the device.
  virtual LineSettings current() const = 0;

  /// Discards bytes received but not read, and bytes written but not sent.
  virtual Error flush() = 0;
};

}  // namespace sbgc::io
