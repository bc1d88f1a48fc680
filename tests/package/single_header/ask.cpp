#include "sbgc.hpp"

sbgc::Outcome ask(sbgc::Session& session);

sbgc::Outcome ask(sbgc::Session& session) {
  auto outcome = sbgc::Outcome::none;
  const auto on_event = [&](const sbgc::Event& event) { outcome = event.outcome; };
  session.send(sbgc::msg::BoardInfoRequest{});
  if (session.poll({0}, on_event).bytes.empty()) return outcome;

  std::array<std::uint8_t, sbgc::max_frame_size> bytes{};
  const auto response = sbgc::encode_frame(sbgc::msg::BoardInfo{}, bytes);
  session.feed({bytes.data(), response.size}, {1000}, on_event);
  return outcome;
}
