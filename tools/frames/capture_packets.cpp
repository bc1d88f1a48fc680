#include "frames/capture_packets.hpp"

#include <string_view>
#include <variant>

#include <sbgc/io/pcapng.hpp>

#include "command/command_error.hpp"
#include "command/input.hpp"

namespace sbgc::tools {

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

void CapturePackets::put() {
  out_.put(std::string_view(reinterpret_cast<const char*>(buffer_.data()), buffer_.size()));
  buffer_.clear();
}

}  // namespace sbgc::tools
