#include "share/host_places.hpp"

#include <algorithm>
#include <utility>

#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/roles.hpp>

namespace sbgc::tools {

namespace {

/// True if the request asks who the board is and what it does.
bool is_look(std::uint8_t id) {
  return id == static_cast<std::uint8_t>(roles::IntroductionRequest::command) ||
         id == static_cast<std::uint8_t>(roles::DetailsRequest::command) ||
         id == static_cast<std::uint8_t>(msg::GetAnglesRequest::command) ||
         id == static_cast<std::uint8_t>(msg::RealtimeData3Request::command);
}

}  // namespace

HostPlaces::Arrival HostPlaces::come(std::size_t port, Instant now,
                                     const SilentSince& silent_since) {
  Host host{.came = now};
  std::optional<std::size_t> replaced;
  const auto taken = std::ranges::count_if(hosts_, [](const auto& one) {
    return one.second.place == Place::usual || one.second.place == Place::kept;
  });
  if (std::cmp_greater_equal(taken, max_hosts)) replaced = silent_host(now, silent_since);
  if (std::cmp_greater_equal(taken, max_hosts) && !replaced) {
    const auto guest = std::ranges::find_if(
        hosts_, [](const auto& one) { return one.second.place == Place::reserved; });
    if (guest == hosts_.end()) {
      host.place = Place::reserved;
    } else if (!guest->second.has_stopped && now - guest->second.came >= time_to_speak) {
      host.place = Place::reserved;
      replaced = guest->first;
    } else if (hosts_.size() >= 2 * max_hosts) {
      return {};  // the other ports are for those who find a place
    } else {
      host.place = Place::none;
    }
  }
  if (replaced) give_up(*replaced);
  hosts_[port] = host;
  return {.is_heard = true, .replaced = replaced};
}

/// The host that a newcomer replaces.
std::optional<std::size_t> HostPlaces::silent_host(Instant now,
                                                   const SilentSince& silent_since) const {
  std::optional<std::size_t> mute;
  std::optional<std::size_t> silent;
  Instant first_came = Instant::never;
  Instant first_silent = Instant::never;
  for (const auto& [port, host] : hosts_) {
    if (host.place != Place::usual) continue;
    if (!host.has_spoken) {
      if (now - host.came < time_to_speak || host.came >= first_came) continue;
      first_came = host.came;
      mute = port;
      continue;
    }
    const Instant since = silent_since(port);
    if (now - since < longest_silence || since >= first_silent) continue;
    first_silent = since;
    silent = port;
  }
  return mute ? mute : silent;
}

bool HostPlaces::serves(std::size_t port, const RawRequest& request) {
  Host& host = hosts_[port];
  if (host.place != Place::reserved) return host.place != Place::none;
  const bool is_stop = request.policy.stops && !request.policy.restarts_board;
  host.has_stopped = host.has_stopped || is_stop;
  return is_stop || is_look(request.id);
}

std::vector<std::size_t> HostPlaces::overdue(Instant now) const {
  std::vector<std::size_t> result;
  for (const auto& [port, host] : hosts_) {
    const Duration passed = now - host.came;
    if ((host.place == Place::reserved && passed >= reserved_time) ||
        (host.place == Place::none && passed >= time_to_speak)) {
      result.push_back(port);
    }
  }
  return result;
}

}  // namespace sbgc::tools
