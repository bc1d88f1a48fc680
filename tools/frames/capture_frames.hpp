/// The frames of a capture file.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include <sbgc/io/capture.hpp>
#include <sbgc/io/internal/arrival_times.hpp>
#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>

#include "frames/rejected_candidates.hpp"

namespace sbgc::tools {

/// Receives the content of a capture in recorded order.
class CaptureListener {
 public:
  CaptureListener() = default;
  CaptureListener(const CaptureListener&) = delete;
  CaptureListener& operator=(const CaptureListener&) = delete;
  virtual ~CaptureListener() = default;

  virtual void on_session(const io::CaptureSession& session) = 0;
  /// Reports a frame in this direction; its last byte arrived at `time`. Its offset counts the
  /// bytes of this direction since the start of the session.
  virtual void on_frame(Direction direction, io::CaptureTime time, const Frame& frame) = 0;
  /// Reports bytes outside of frames; called before the next frame, or at the end of the session.
  /// The offsets in `rejected` count like those of frames.
  virtual void on_skipped(Direction direction, io::CaptureTime time, std::uint64_t size,
                          std::span<const RejectedCandidate> rejected) = 0;
  virtual void on_note(io::CaptureTime time, std::string_view text) = 0;
  virtual void on_damage(const io::CaptureDamage& damage) = 0;
};

/// Finds the frames of a capture, separately for each direction and session.
class CaptureFrames {
 public:
  explicit CaptureFrames(CaptureListener& listener) : listener_(listener) {}

  /// Parses the next bytes of the file.
  void feed(std::span<const std::uint8_t> bytes);
  /// Must be called at the end.
  void finish();

  /// The parser counters of one direction, summed over all finished sessions.
  const ParserCounters& counters(Direction direction) const { return side(direction).total; }

 private:
  struct Side {
    Direction direction{};
    ParserOfAll parser{};
    io::detail::ArrivalTimes arrivals{};  // of the bytes fed that wait in the parser
    std::uint64_t reported = 0;           // bytes reported to the listener
    GapExplainer explainer{direction};
    ParserCounters total{};
  };

  void take_items();
  void take(const io::CaptureRecord& record);
  void take_frame(Side& side, const Frame& frame);
  /// Ends a gap at `until`; the next one can begin at `next`.
  void report_skipped(Side& side, std::uint64_t until, std::uint64_t next, io::CaptureTime time);
  void end_session();

  const Side& side(Direction direction) const {
    return sides_[direction == Direction::from_board ? 1 : 0];
  }

  CaptureListener& listener_;
  io::CaptureParser parser_;
  std::array<Side, 2> sides_{Side{.direction = Direction::to_board},
                             Side{.direction = Direction::from_board}};
  io::CaptureTime last_{};
};

}  // namespace sbgc::tools
