/// The host of an emulated board in tests: it sends requests, advances time and records responses.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/any.hpp>
#include <sbgc/emulator/board.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/time.hpp>

namespace sbgc::test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A message without its frame, and its time of arrival.
struct Packet {
  std::uint8_t id{};
  std::vector<std::uint8_t> body{};
  Instant at{};
  Framing framing{};
};

using Packets = std::vector<Packet>;

template <class M>
bool is(const Packet& packet) {
  return packet.id == static_cast<std::uint8_t>(M::command) && packet.body.size() >= M::min_size;
}

/// Returns the message in a packet. Fails the test if it is not an M.
template <class M>
M message(const Packet& packet) {
  M result{};
  EXPECT_TRUE(is<M>(packet) && decode(std::span(packet.body), result)) << "it is another message";
  return result;
}

/// Returns the messages M among the packets.
template <class M>
std::vector<M> all(const Packets& packets) {
  std::vector<M> result;
  for (const Packet& one : packets) {
    if (is<M>(one)) result.push_back(message<M>(one));
  }
  return result;
}

/// Returns a request with the values of a new message or, if that has no body, with as few elements
/// as possible.
inline AnyMessage any_request(const MessageType& type) {
  AnyMessage request = type.make();
  std::array<std::uint8_t, max_body_size> body{};
  if (request.encode(body)) return request;
  body = {};
  EXPECT_TRUE(request.decode(std::span<const std::uint8_t>(body).first(type.info->min_size)));
  return request;
}

/// The newest board and firmware, with all features.
inline emulator::BoardOptions newest_board() {
  emulator::BoardOptions options;
  options.board = msg::BoardVersion(36);
  options.firmware = msg::FirmwareVersion(newest_firmware);
  return options;
}

/// A board that has started, and a host on one of its ports.
class Host {
 public:
  explicit Host(const emulator::BoardOptions& options = {}, emulator::Memory memory = {})
      : board(options, std::move(memory), Instant{}), port(board.open_port().value()) {
    listen(options.start_time + milliseconds(1));
  }

  /// Advances time; returns the packets that arrive meanwhile.
  Packets listen(Duration duration) {
    const Instant end = now + duration;
    Packets result;
    for (;;) {
      const Instant next = later(now, earlier(board.next(), end));
      now = next;
      board.advance(now);
      collect(result);
      if (now == end) return result;
    }
  }

  /// Sends bytes unchanged.
  void send_bytes(std::span<const std::uint8_t> bytes) { board.receive(port, bytes, now); }
  template <Message M>
  void send(const M& message) {
    std::array<std::uint8_t, max_frame_size> frame{};
    const WriteResult written = encode_frame(framing, message, frame);
    ASSERT_TRUE(written);
    send_bytes(std::span(frame).first(written.size));
  }
  void send(const AnyMessage& message) {
    std::array<std::uint8_t, max_frame_size> frame{};
    const WriteResult written = message.encode_frame(framing, frame);
    ASSERT_TRUE(written);
    send_bytes(std::span(frame).first(written.size));
  }

  /// Sends a request and waits; returns the packets that arrive meanwhile.
  template <class M>
  Packets ask(const M& request, Duration wait = milliseconds(50)) {
    send(request);
    return listen(wait);
  }
  /// Returns the response to a request. Fails the test unless it is exactly one packet of that
  /// type.
  template <class Answer, Message M>
  Answer get(const M& request, Duration wait = milliseconds(50)) {
    const Packets packets = ask(request, wait);
    EXPECT_EQ(packets.size(), 1U);
    return packets.empty() ? Answer{} : message<Answer>(packets.front());
  }

  emulator::Board board;
  std::size_t port;
  Instant now{};
  Framing framing = basic_framing;  ///< of requests

 private:
  void collect(Packets& into) {
    const auto bytes = board.output(port);
    parser_.feed(bytes, [&](const Frame& frame) {
      into.push_back({frame.id, {frame.body.begin(), frame.body.end()}, now, frame.framing});
    });
    board.sent(port, bytes.size(), now);
  }

  ParserOfAll parser_;
};

/// Returns the number of confirmations of M among the packets.
template <class M>
std::ptrdiff_t confirmations(const Packets& packets) {
  const auto all_of_them = all<msg::Confirm>(packets);
  return std::count_if(all_of_them.begin(), all_of_them.end(),
                       [](const msg::Confirm& one) { return one.cmd == M::command; });
}

/// Returns true if the only response to the request is a confirmation.
template <Message M>
bool is_confirmed(Host& host, const M& request) {
  const Packets packets = host.ask(request);
  return packets.size() == 1 && confirmations<M>(packets) == 1;
}
}  // namespace sbgc::test
