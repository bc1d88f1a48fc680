#include "share/request_owners.hpp"

#include <algorithm>

#include <sbgc/roles.hpp>

namespace sbgc::tools {

void RequestOwners::asked(std::uint64_t tag, const RequestOwner& asker, const RawRequest& request,
                          Instant now) {
  const ResponsePolicy& policy = request.policy;
  // The last request of a kind says as much as all earlier ones that are only remembered.
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
  // A body of a wrong size is an answer, too, which does not decode.
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
    // Whoever has left does not make it another's.
    if (is_anonymous && !entry.asker && !entry.is_due(now)) continue;
    if (entry.is_due(now)) {
      // A later task ends the one before.
      if (next == nullptr || next->confirmed != 0) next = &entry;
    } else if (entry.missing == 0 && now < entry.due) {
      last_answered = &entry;
    }
    is_of_one = is_of_one && (last == nullptr || is_same_host(entry, *last));
    last = &entry;
  }
  if (last == nullptr) return {};
  // Confirmations and errors are counted, and the only answer to a request without documented
  // ones; other answers can be several.
  const bool is_counted = is_error || roles::is_confirmation(frame) ||
                          (next != nullptr && !next->responses.are_possible());
  Entry* owner = nullptr;
  if (is_anonymous && !is_of_one) {
    // It can be any.
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
