#include "frames/capture_packets.hpp"

#include <string_view>
#include <variant>

#include <sbgc/io/pcapng.hpp>

#include "command/command_error.hpp"
#include "command/input_output.hpp"
#include "command/remark.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

void put_bytes(StandardOutput& out, std::vector<std::uint8_t>& bytes) {
  out.put(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  bytes.clear();
}

}  // namespace

void CapturePackets::feed(std::span<const std::uint8_t> bytes) {
  parser_.feed(bytes);
  take_items();
}

int CapturePackets::finish() {
  parser_.finish();
  take_items();
  out_.flush();
  if (!problems_.empty()) throw InputError(problems_);
  return success;
}

void CapturePackets::take_items() {
  while (const auto item = parser_.next()) {
    if (const auto* const record = std::get_if<io::CaptureRecord>(&*item)) {
      take(*record);
    } else if (const auto* const session = std::get_if<io::CaptureSession>(&*item)) {
      begin_session(*session);
    } else {
      problems_ += (problems_.empty() ? "" : " ") + to_string(std::get<io::CaptureDamage>(*item));
    }
  }
}

void CapturePackets::begin_session(const io::CaptureSession& session) {
  if (!first_) {
    first_ = session;
    io::pcapng::append_section(buffer_);
  }
  session_ = session;
  comments_.clear();
  io::pcapng::append_packet(buffer_, session.start, io::CaptureKind::note, {});
  put();
}

void CapturePackets::take(const io::CaptureRecord& record) {
  if (record.kind == io::CaptureKind::note) {
    comments_.emplace_back(record.bytes.begin(), record.bytes.end());
  }
  if (record.kind != io::CaptureKind::from_board && record.kind != io::CaptureKind::to_board) {
    return;
  }
  const Direction direction =
      record.kind == io::CaptureKind::from_board ? Direction::from_board : Direction::to_board;
  if (!wants_(direction, session_.start - first_->start + record.time)) return;
  io::pcapng::append_packet(buffer_, session_.start + record.time, record.kind, record.bytes,
                            comments_);
  comments_.clear();
  put();
}

void CapturePackets::put() { put_bytes(out_, buffer_); }

BytePackets::BytePackets(StandardOutput& out, Direction direction)
    : out_(out),
      kind_(direction == Direction::from_board ? io::CaptureKind::from_board
                                               : io::CaptureKind::to_board) {
  std::vector<std::uint8_t> buffer;
  io::pcapng::append_section(buffer);
  put_bytes(out_, buffer);
}

void BytePackets::feed(std::span<const std::uint8_t> bytes) {
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  parser_.feed(bytes, [this](const Frame& frame) { put(frame); });
  put_until(begin_ + waiting_.size() - parser_.waiting_bytes());
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(end_ - begin_));
  begin_ = end_;
}

void BytePackets::stop() {
  parser_.flush([this](const Frame& frame) { put(frame); });
  put_until(begin_ + waiting_.size());
  out_.flush();
}

int BytePackets::finish() {
  stop();
  if (parser_.counters().frames != 0 || end_ == 0) return success;
  remark_failure("found no frame in " + counted(end_, "byte"));
  return failure;
}

void BytePackets::put(const Frame& frame) {
  put_until(frame.offset);
  put_until(frame.offset + frame_size(frame.framing, frame.body.size()));
}

void BytePackets::put_until(std::uint64_t end) {
  if (end <= end_) return;
  const auto bytes = std::span(waiting_).subspan(end_ - begin_, end - end_);
  std::vector<std::uint8_t> packet;
  io::pcapng::append_packet(packet, {}, kind_, bytes);
  put_bytes(out_, packet);
  end_ = end;
}

}  // namespace sbgc::tools
