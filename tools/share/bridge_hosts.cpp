#include "share/bridge_hosts.hpp"

#include <algorithm>
#include <utility>

#include <sbgc/any.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/roles.hpp>

namespace sbgc::tools {

namespace {

/// True if the request asks for the identity of the board.
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

/// Returns the host that a newcomer replaces.
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

void RequestOwners::asked(std::uint64_t tag, const RequestOwner& asker, const RawRequest& request,
                          Instant now) {
  const ResponsePolicy& policy = request.policy;
  // The last request of a kind replaces all earlier ones that are only remembered.
  std::erase_if(entries_, [&](const Entry& entry) {
    if (entry.is_due(now)) return false;
    const bool is_same =
        entry.asker && entry.asker->port == asker.port && entry.responses == policy.responses;
    return is_same || now - entry.at > memory;
  });
  if (entries_.size() == most) entries_.pop_front();
  const unsigned confirmations = std::max<unsigned>(policy.confirmations, 1);
  entries_.push_back(
      {.tag = tag,
       .asker = asker,
       .responses = policy.responses,
       .missing = policy.responses.form_count != 0 ? 1U : confirmations,
       .patience = sbgc::milliseconds(std::max(policy.timeout_ms, policy.finish_ms)) + lateness,
       .at = now});
}

auto RequestOwners::find(std::uint64_t tag) -> Entry* {
  const auto place = std::ranges::lower_bound(entries_, tag, {}, &Entry::tag);
  return place == entries_.end() || place->tag != tag ? nullptr : &*place;
}

void RequestOwners::Entry::take(const Frame& frame, Instant now) {
  if (roles::is_confirmation(frame)) ++confirmed;
  if (missing != 0) missing = roles::is_error(frame) ? 0 : missing - 1;
  if (missing == 0) due = now + lateness;
}

void RequestOwners::answered(std::uint64_t tag, const Frame& frame, Instant now) {
  if (Entry* const entry = find(tag)) entry->take(frame, now);
}

void RequestOwners::ended(std::uint64_t tag, bool timed_out, Instant now) {
  Entry* const entry = find(tag);
  if (entry == nullptr || entry->missing == 0) return;
  entry->due = now + (timed_out ? lateness : entry->patience);
}

void RequestOwners::withdrawn(std::uint64_t tag) {
  std::erase_if(entries_, [&](const Entry& entry) { return entry.tag == tag; });
}

void RequestOwners::left(std::size_t port) {
  for (Entry& entry : entries_) {
    if (entry.asker && entry.asker->port == port) entry.asker.reset();
  }
}

bool RequestOwners::awaits_answer(std::size_t port, Instant now) const {
  return std::ranges::any_of(entries_, [&](const Entry& entry) {
    return entry.asker && entry.asker->port == port && entry.is_due(now);
  });
}

bool RequestOwners::Entry::can_be_answered_by(const Frame& frame) const {
  if (roles::is_confirmation(frame)) {
    return roles::confirmed_command(frame) == responses.command &&
           responses.confirmation.holds(frame.body);
  }
  if (roles::is_error(frame)) {
    const std::uint8_t failed = roles::failed_command(frame);
    return failed == responses.command || failed == 0;
  }
  // A body of a wrong size is also an answer, which does not decode.
  if (responses.form_of(frame, true) != nullptr) return true;
  // Not every answer is documented.
  return frame.id == responses.command &&
         std::none_of(responses.forms.begin(), responses.forms.begin() + responses.form_count,
                      [&](const ResponseForm& form) { return form.id == frame.id; });
}

bool RequestOwners::is_same_host(const Entry& one, const Entry& other) {
  return one.asker && other.asker && one.asker->port == other.asker->port;
}

auto RequestOwners::claim(const Frame& frame, Instant now) -> Claim {
  if (roles::is_reset(frame)) return {};
  const bool is_error = roles::is_error(frame);
  const bool is_anonymous = is_error && roles::failed_command(frame) == 0;
  Entry* next = nullptr;           // of those without an answer
  Entry* last_answered = nullptr;  // a moment ago
  Entry* last = nullptr;
  bool is_of_one = true;
  for (Entry& entry : entries_) {
    if (!entry.is_due(now) && now - entry.at > memory) continue;
    if (!entry.can_be_answered_by(frame)) continue;
    // If a host has left, its answer does not become another's.
    if (is_anonymous && !entry.asker && !entry.is_due(now)) continue;
    if (entry.is_due(now)) {
      // A later task ends the previous one.
      if (next == nullptr || next->confirmed != 0) next = &entry;
    } else if (entry.missing == 0 && now < entry.due) {
      last_answered = &entry;
    }
    is_of_one = is_of_one && (last == nullptr || is_same_host(entry, *last));
    last = &entry;
  }
  if (last == nullptr) return {};
  // Confirmations and errors are counted, and so is the only answer to a request without documented
  // ones; other answers may occur several times.
  const bool is_counted = is_error || roles::is_confirmation(frame) ||
                          (next != nullptr && !next->responses.are_possible());
  Entry* owner = nullptr;
  if (is_anonymous && !is_of_one) {
    // It can be any answer.
  } else if (next != nullptr && (is_counted || last_answered == nullptr)) {
    owner = next;
  } else if (last_answered != nullptr) {
    owner = last_answered;
  } else if (is_of_one) {
    owner = last;
  }
  if (owner == nullptr) return {.is_answer = true};
  const bool is_awaited = owner->is_due(now);
  owner->take(frame, now);
  return {.is_answer = true, .is_awaited = is_awaited, .asker = owner->asker};
}

}  // namespace sbgc::tools
