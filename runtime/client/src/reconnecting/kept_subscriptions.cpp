#include "reconnecting/kept_subscriptions.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace sbgc::detail {

void KeptSubscriptions::drop(const Kept& kept) {
  kept->is_cancelled = true;
  std::erase(kept_, kept);
  if (kept->current) dropped_.push_back(std::move(kept->current));
}

void KeptSubscriptions::set(const Kept& kept, Subscription registration, std::uint64_t connection,
                            Time now) {
  std::swap(kept->current, registration);
  kept->connection = connection;
  kept->changed = now;
  if (registration) dropped_.push_back(std::move(registration));
  if (kept->is_cancelled) dropped_.push_back(std::move(kept->current));
}

auto KeptSubscriptions::without_request() const -> std::vector<Kept> {
  std::vector<Kept> result;
  std::ranges::copy_if(kept_, std::back_inserter(result),
                       [](const Kept& kept) { return kept->interval.count() == 0; });
  return result;
}

auto KeptSubscriptions::next_to_restore(std::uint64_t connection) const -> Kept {
  const auto place = std::ranges::find_if(kept_, [connection](const Kept& kept) {
    return kept->connection != connection && kept->refused != connection;
  });
  return place == kept_.end() ? nullptr : *place;
}

auto KeptSubscriptions::silent_stream(std::uint64_t connection, std::chrono::milliseconds longest,
                                      Time now) -> Kept {
  Kept silent;
  for (const Kept& kept : kept_) {
    if (kept->interval.count() == 0 || kept->connection != connection) continue;
    const std::int64_t messages = kept->messages;
    if (messages != kept->counted) {
      kept->counted = messages;
      kept->changed = now;
    }
    if (now - kept->changed > std::max<std::chrono::microseconds>(longest, 3 * kept->interval)) {
      silent = kept;
    }
  }
  return silent;
}

std::vector<Subscription> KeptSubscriptions::take_dropped() { return std::exchange(dropped_, {}); }

std::vector<Subscription> KeptSubscriptions::take_all() {
  std::vector<Subscription> all = take_dropped();
  for (const Kept& kept : kept_) {
    kept->connection = 0;
    if (kept->current) all.push_back(std::move(kept->current));
  }
  return all;
}

}  // namespace sbgc::detail
