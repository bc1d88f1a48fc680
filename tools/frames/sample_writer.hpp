/// Text formats of the samples of a data stream.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/text/leaves.hpp>

namespace sbgc::tools {

/// A value in samples.
struct StreamField {
  std::string path{};  ///< for example "angle.roll"
  std::string unit{};  ///< "" if it has none
};

/// Calls its argument with each value of a sample.
using Sample = std::function<void(const std::function<void(const Leaf&)>&)>;

/// The layout of the output. All numbers are written independently of the locale.
enum class OutputFormat : unsigned char {
  text,   ///< for people
  csv,    ///< a header line with units, then one line per message; numbers, empty where missing
  jsonl,  ///< one object per message
};

/// Returns the format for a value of --format.
OutputFormat format_named(std::string_view name);

/// The first column of a table in CSV.
enum class SampleKey : unsigned char {
  time,       ///< in seconds
  unix_time,  ///< in seconds since 1970
  offset,     ///< of the frame, in bytes
};

/// Formats samples one by one.
class SampleWriter {
 public:
  /// `width` limits the lines of a text table; 0: no limit.
  static std::unique_ptr<SampleWriter> make(OutputFormat format, std::string message,
                                            std::vector<StreamField> fields, std::size_t width,
                                            SampleKey key = SampleKey::time);

  SampleWriter(const SampleWriter&) = delete;
  SampleWriter& operator=(const SampleWriter&) = delete;
  virtual ~SampleWriter() = default;

  /// Returns the lines before the first sample.
  virtual std::string header() const = 0;
  /// Returns the line of a sample that arrived at this time, in seconds.
  virtual std::string line(double time, const Sample& sample) const = 0;

 protected:
  SampleWriter() = default;
};

}  // namespace sbgc::tools
