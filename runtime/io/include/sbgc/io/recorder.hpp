/// Records the traffic of a transport.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include <sbgc/io/capture.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// Options of a recorder.
struct RecorderOptions {
  /// Called once if writing the file fails. The transport continues without recording.
  std::function<void(const Error&)> on_error{};
  std::function<CaptureWriter::Clock::time_point()> now = [] {
    return CaptureWriter::Clock::now();
  };
};

/// Returns a transport that forwards to `inner` and records its traffic in `file`: bytes read when
/// they arrive, bytes written when they are passed in, and as notes the description, line changes
/// and final errors.
std::unique_ptr<Transport> record(std::unique_ptr<Transport> inner, CaptureWriter file,
                                  RecorderOptions options = {});

}  // namespace sbgc::io
