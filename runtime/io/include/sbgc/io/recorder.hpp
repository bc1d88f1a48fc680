/// Records a conversation while it goes on.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include <sbgc/io/capture.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc::io {

struct RecorderOptions {
  /// Called once if the file can not be written any more. The conversation goes on regardless.
  std::function<void(const Error&)> on_error{};
  std::function<CaptureWriter::Clock::time_point()> now = [] {
    return CaptureWriter::Clock::now();
  };
};

/// `inner`, with everything that passes written to `file`: what is read when it arrives, what is
/// written when it is handed over, and as notes what it is, changes of the line, and how it ends.
std::unique_ptr<Transport> record(std::unique_ptr<Transport> inner, CaptureWriter file,
                                  RecorderOptions options = {});

}  // namespace sbgc::io
