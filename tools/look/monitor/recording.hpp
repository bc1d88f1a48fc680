/// A capture that begins and ends while the line is in use.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include <sbgc/io/capture.hpp>
#include <sbgc/io/observer.hpp>

namespace sbgc::tools {

/// Records the line while it is on. Thread-safe. The functions for the user return what to tell.
class Recording final : public io::Observer {
 public:
  /// False, too, if the file can no longer be written, which begin_or_end() tells.
  bool is_on() const;
  /// Begins a file in this folder that is named by the time, or ends it. `line` describes the line.
  std::string begin_or_end(const std::string& line);
  /// Writes a note with a number into the file.
  std::string mark();

  void on_read(std::span<const std::uint8_t> bytes) override;
  void on_written(std::span<const std::uint8_t> bytes) override;
  void on_line_set(const LineSettings& settings) override;

 private:
  using Clock = io::CaptureWriter::Clock;

  void add(io::CaptureKind kind, std::span<const std::uint8_t> bytes);

  mutable std::mutex mutex_;
  std::optional<io::CaptureWriter> file_{};
  std::string name_{};
  std::size_t marks_ = 0;
};

}  // namespace sbgc::tools
