// Core and session: a request, and its response from a frame that was encoded here.

#include <array>
#include <cstdint>
#include <cstdio>

#include <sbgc/message.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/responses/system.hpp>
#include <sbgc/session.hpp>

int main() {
  static sbgc::Session session;
  bool answered = false;
  const auto on_event = [&](const sbgc::Event& event) {
    answered = event.outcome == sbgc::Outcome::answered;
  };
  session.send(sbgc::msg::BoardInfoRequest{});
  const bool asked = !session.poll({0}, on_event).bytes.empty();

  std::array<std::uint8_t, sbgc::max_frame_size> bytes{};
  const auto response = sbgc::encode_frame(sbgc::msg::BoardInfo{}, bytes);
  session.feed({bytes.data(), response.size}, {1000}, on_event);
  std::puts(asked && answered ? "the board has answered" : "the session does not work");
  return asked && answered ? 0 : 1;
}
