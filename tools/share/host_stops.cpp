#include "share/host_stops.hpp"

#include <algorithm>
#include <utility>

#include <sbgc/any.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/roles.hpp>

namespace sbgc::tools {

namespace {

bool is_still(const msg::GetAngles& state) {
  for (std::size_t i = 0; i < state.axes.size(); ++i) {
    if (state.axes[i].rc_speed.raw() != 0) return false;
  }
  return true;
}

OwedStop owed_for(const RawRequest& request) {
  if (request.id != static_cast<std::uint8_t>(msg::MotorsOff::command)) return {};
  const MessageType* const type =
      find_message(Direction::to_board, request.id, request.body.size());
  if (type == nullptr) return {};
  AnyMessage message(*type);
  return message.decode(request.body) ? OwedStop(std::move(message)) : OwedStop();
}

}  // namespace

void HostStops::asked(std::size_t port, std::uint64_t tag, const RawRequest& request) {
  if (!request.policy.moves) return;
  if (!request.policy.stops) return debts_.clear();
  OwedStop owed = owed_for(request);
  std::erase_if(debts_, [&](const Debt& one) {
    return one.port == port && one.owed.turns_motors_off() == owed.turns_motors_off();
  });
  debts_.push_back({port, tag, std::move(owed)});
  still_since_ = Instant::never;
}

void HostStops::answered(std::uint64_t tag, const Frame& frame) {
  if (roles::is_error(frame)) return;
  std::erase_if(debts_,
                [&](const Debt& one) { return one.tag == tag && one.owed.turns_motors_off(); });
}

void HostStops::arrived(const Frame& frame, Instant now) {
  if (debts_.empty() || frame.id != static_cast<std::uint8_t>(msg::GetAngles::command)) return;
  msg::GetAngles state;
  if (!decode(frame.body, state)) return;
  still_since_ = is_still(state) ? earlier(still_since_, now) : Instant::never;
  if (still_since_ == Instant::never || now - still_since_ < rest) return;
  std::erase_if(debts_, [](const Debt& one) { return !one.owed.turns_motors_off(); });
}

std::vector<OwedStop> HostStops::left(std::size_t port) {
  std::vector<OwedStop> result;
  for (Debt& one : debts_) {
    if (one.port == port) result.push_back(std::move(one.owed));
  }
  std::erase_if(debts_, [&](const Debt& one) { return one.port == port; });
  return result;
}

}  // namespace sbgc::tools
