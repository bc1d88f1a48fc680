#include "serving/frame_log.hpp"

#include <utility>

#include <fmt/format.h>

#include "decoded_frame.hpp"
#include "text.hpp"

namespace sbgc::emulate {

namespace {

const char* to_text(board::Outcome outcome) {
  switch (outcome) {
    case board::Outcome::carried_out: return "carried out";
    case board::Outcome::refused: return "refused";
    case board::Outcome::unknown: return "unknown here";
    case board::Outcome::malformed: return "malformed";
    case board::Outcome::lost: return "lost: no room";
    case board::Outcome::not_listening: return "not listening";
  }
  return "?";
}

}  // namespace

std::string to_text(const board::Board::Traffic& traffic) {
  const Direction direction = traffic.outcome ? Direction::to_board : Direction::from_board;
  const Frame& frame = traffic.frame;
  const std::string name = tools::command_name(frame.id, direction);
  std::string result = fmt::format(
      "{:10.4f}  host {} {} {} ({}), {}", static_cast<double>(traffic.at.us) * 1e-6, traffic.port,
      traffic.outcome ? '>' : '<', name.empty() ? "unknown command" : name, frame.id,
      tools::counted(frame.body.size(), "byte"));
  if (traffic.outcome) result += fmt::format("  {}", to_text(*traffic.outcome));
  return result;
}

void TrafficLines::add(const board::Board::Traffic& traffic) {
  if (traffic.at != at_ || traffic.port != port_) answers_ = 0;
  at_ = traffic.at;
  port_ = traffic.port;
  const bool is_request = traffic.outcome.has_value();
  const auto place = lines_.end() - static_cast<std::ptrdiff_t>(is_request ? answers_ : 0);
  lines_.insert(place, to_text(traffic));
  answers_ = is_request ? 0 : answers_ + 1;
}

std::vector<std::string> TrafficLines::take() {
  answers_ = 0;
  return std::exchange(lines_, {});
}

}  // namespace sbgc::emulate
