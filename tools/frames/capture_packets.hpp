/// Captures as packets for Wireshark.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <sbgc/io/capture.hpp>
#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>

#include "command/input_output.hpp"

namespace sbgc::tools {

/// Writes the records of a capture file as a pcapng file.
class CapturePackets {
 public:
  /// Selects records by their direction and the time since the start of the capture.
  using Wants = std::function<bool(Direction, std::chrono::microseconds)>;

  CapturePackets(StandardOutput& out, Wants wants) : out_(out), wants_(std::move(wants)) {}

  void feed(std::span<const std::uint8_t> bytes);
  /// Returns the exit status. Throws InputError if parts of the capture are damaged.
  int finish();

 private:
  void take_items();
  void take(const io::CaptureRecord& record);
  void begin_session(const io::CaptureSession& session);
  void put();

  StandardOutput& out_;
  Wants wants_;
  io::CaptureParser parser_;
  std::optional<io::CaptureSession> first_;  // session
  io::CaptureSession session_;
  std::vector<std::string> comments_;  // of the next packet
  std::vector<std::uint8_t> buffer_;
  std::string problems_;
};

/// Writes bytes of one sender as a pcapng file: each frame, and each gap between frames, is a
/// packet. Their times are unknown: all are 0, in 1970.
class BytePackets {
 public:
  BytePackets(StandardOutput& out, Direction direction);

  void feed(std::span<const std::uint8_t> bytes);
  void stop();
  /// Like stop(). Returns the exit status.
  int finish();

 private:
  void put(const Frame& frame);
  void put_until(std::uint64_t end);

  StandardOutput& out_;
  io::CaptureKind kind_;
  ParserOfAll parser_;
  std::vector<std::uint8_t> waiting_;  // bytes from `begin_` on
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;  // of the packets
};

}  // namespace sbgc::tools
