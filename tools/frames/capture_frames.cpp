#include "frames/capture_frames.hpp"

#include <string>
#include <variant>
#include <vector>

namespace sbgc::tools {

void CaptureFrames::feed(std::span<const std::uint8_t> bytes) {
  parser_.feed(bytes);
  take_items();
}

void CaptureFrames::finish() {
  parser_.finish();
  take_items();
  end_session();
}

void CaptureFrames::take_items() {
  while (const auto item = parser_.next()) {
    if (const auto* const record = std::get_if<io::CaptureRecord>(&*item)) {
      take(*record);
    } else if (const auto* const session = std::get_if<io::CaptureSession>(&*item)) {
      end_session();
      listener_.on_session(*session);
    } else {
      listener_.on_damage(std::get<io::CaptureDamage>(*item));
    }
  }
}

void CaptureFrames::take(const io::CaptureRecord& record) {
  last_ = record.time;
  if (record.kind == io::CaptureKind::note) {
    listener_.on_note(record.time, std::string(record.bytes.begin(), record.bytes.end()));
  }
  if (record.kind != io::CaptureKind::to_board && record.kind != io::CaptureKind::from_board) {
    return;
  }
  Side& side = sides_[record.kind == io::CaptureKind::from_board ? 1 : 0];
  side.arrivals.add(record.bytes.size(), record.time);
  side.explainer.add(record.bytes);
  side.parser.feed(record.bytes, [&](const Frame& frame) { take_frame(side, frame); });
  const std::uint64_t decided = side.arrivals.size() - side.parser.waiting_bytes();
  side.explainer.advance(decided);
  side.arrivals.forget(decided);
}

void CaptureFrames::take_frame(Side& side, const Frame& frame) {
  const std::uint64_t end = frame.offset + frame_size(frame.framing, frame.body.size());
  const io::CaptureTime time = side.arrivals.of(end);
  report_skipped(side, frame.offset, end, time);
  listener_.on_frame(side.direction, time, frame);
  side.reported = end;
}

void CaptureFrames::report_skipped(Side& side, std::uint64_t until, std::uint64_t next,
                                   io::CaptureTime time) {
  const std::vector<RejectedCandidate> rejected = side.explainer.end_gap(until, next);
  if (until > side.reported)
    listener_.on_skipped(side.direction, time, until - side.reported, rejected);
}

void CaptureFrames::end_session() {
  for (Side& side : sides_) {
    side.parser.flush([&](const Frame& frame) { take_frame(side, frame); });
    report_skipped(side, side.arrivals.size(), side.arrivals.size(), last_);
    const ParserCounters now = side.parser.counters();
    side = Side{.direction = side.direction, .total = side.total + now};
  }
  last_ = {};
}

}  // namespace sbgc::tools
