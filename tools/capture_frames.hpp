/// The frames of a capture file.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <string_view>

#include <sbgc/io/capture.hpp>
#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>

#include "rejected_candidates.hpp"

namespace sbgc::tools {

/// Is reported what is in a capture, in the order in which it was recorded.
class CaptureListener {
 public:
  CaptureListener() = default;
  CaptureListener(const CaptureListener&) = delete;
  CaptureListener& operator=(const CaptureListener&) = delete;
  virtual ~CaptureListener() = default;

  virtual void on_session(const io::CaptureSession& session) = 0;
  /// A frame that went in this direction; its last byte came at `time`. Its offset counts the bytes
  /// of that direction since the session began.
  virtual void on_frame(Direction direction, io::CaptureTime time, const Frame& frame) = 0;
  /// In front of a frame, or at the end of the session: bytes that are in no frame. The offsets in
  /// `rejected` count as those of frames do.
  virtual void on_skipped(Direction direction, io::CaptureTime time, std::uint64_t size,
                          std::span<const RejectedCandidate> rejected) = 0;
  virtual void on_note(io::CaptureTime time, std::string_view text) = 0;
  virtual void on_damage(const io::CaptureDamage& damage) = 0;
};

/// Finds the frames of a capture, those of each direction and session for themselves.
class CaptureFrames {
 public:
  explicit CaptureFrames(CaptureListener& listener) : listener_(listener) {}

  /// Takes the next bytes of the file.
  void feed(std::span<const std::uint8_t> bytes);
  /// To be called at the end.
  void finish();

  /// What the parser of one direction has seen, in all sessions that are over.
  const ParserCounters& counters(Direction direction) const { return side(direction).total; }

 private:
  /// When the bytes up to `end` were there.
  struct Mark {
    std::uint64_t end;
    io::CaptureTime time;
  };

  struct Side {
    Direction direction{};
    Parser parser{};
    std::uint64_t size = 0;      // bytes fed
    std::uint64_t reported = 0;  // of them, that the listener knows of
    GapExplainer explainer{direction};
    std::deque<Mark> marks{};  // of the bytes that wait in the parser
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
