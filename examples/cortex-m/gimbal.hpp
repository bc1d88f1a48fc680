// A gimbal at the UART, on a bare loop: one request at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/session.hpp>

#include "board.hpp"

class Gimbal {
 public:
  /// Returns the time since the start. Call it at least every minute.
  sbgc::Instant now() {
    const std::uint32_t us = board::microseconds();
    now_ = now_ + sbgc::microseconds(us - read_us_);
    read_us_ = us;
    return now_;
  }

  /// Sends a request to which the board sends no message, or only a confirmation.
  template <class Request>
  sbgc::Outcome tell(const Request& request) {
    return finish(session_.send(request), nullptr, nullptr);
  }

  /// Sends a request, and decodes the response if the outcome is `answered`.
  template <class Request, class Response = typename Request::Response>
  sbgc::Outcome ask(const Request& request, Response& response) {
    return finish(session_.send(request), &response, [](const sbgc::Frame& frame, void* to) {
      return static_cast<bool>(sbgc::decode(frame.body, *static_cast<Response*>(to)));
    });
  }

  /// Lets time pass. The session receives what the board sends meanwhile.
  void wait(sbgc::Duration duration) {
    const sbgc::Instant end = now() + duration;
    while (now() < end) turn();
  }

  /// Returns how often the loop has turned.
  std::uint32_t turns() const { return turns_; }

 private:
  using Decode = bool (*)(const sbgc::Frame& frame, void* to);

  /// Turns the loop until the request has ended.
  sbgc::Outcome finish(const sbgc::SendResult& sent, void* response, Decode decode) {
    if (!sent) return sbgc::Outcome::failed;
    pending_ = {sent.handle, response, decode};
    while (pending_.outcome == sbgc::Outcome::none) turn();
    return pending_.outcome;
  }

  /// One turn of the loop: the session gets what has arrived, the board what is due.
  void turn() {
    // One type of sink: each further type would be another copy of the session's code.
    const auto sink = [this](const sbgc::Event& event) { take(event); };
    std::array<std::uint8_t, 16> bytes;
    std::size_t size = 0;
    while (size < bytes.size() && board::receive(bytes[size])) ++size;
    session_.feed({bytes.data(), size}, now(), sink);
    board::send(session_.poll(now(), sink).bytes);
    ++turns_;
    // Other work of the firmware belongs here, and what its watchdog needs.
  }

  void take(const sbgc::Event& event) {
    if (event.kind != sbgc::EventKind::completed || event.handle != pending_.handle) return;
    pending_.outcome = event.outcome;
    if (event.outcome != sbgc::Outcome::answered || pending_.decode == nullptr) return;
    // The frame is gone when this function has returned.
    if (!pending_.decode(event.frame, pending_.response)) pending_.outcome = sbgc::Outcome::failed;
  }

  struct Pending {
    sbgc::Handle handle{};
    void* response{};
    Decode decode{};
    sbgc::Outcome outcome{};
  };

  using Formats = sbgc::FrameFormats<sbgc::CrcTable::nibbles, sbgc::Framing::v1>;
  static constexpr sbgc::SessionCapacity capacity{
      .requests = 1, .late_replies = 2, .streams = 0, .body = 32, .optimize = sbgc::Optimize::size};
  sbgc::BasicSession<capacity, Formats> session_;
  Pending pending_{};
  sbgc::Instant now_{};
  std::uint32_t read_us_{};
  std::uint32_t turns_{};
};
