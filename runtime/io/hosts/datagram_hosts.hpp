/// Hosts that send datagrams, and their eviction.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <asio/ip/udp.hpp>

#include <sbgc/time.hpp>

namespace sbgc::hosts {

/// UDP does not report that a sender has left, and anyone can send from any number of addresses.
/// Therefore the number of places is limited, and a new host replaces the one that has been silent
/// longest: among those that have not sent again after an answer, or else among those to which
/// nothing was sent either for some time. A sender that found no place and retries takes precedence
/// over any number of first-time senders.
///
/// This is for an emulated board and a replay, which have few places; a bridge decides itself.
class DatagramHosts {
 public:
  /// The time for which a place is protected from first-time senders after its first datagram, and
  /// from all senders after the last datagram from or to a host that has sent again.
  static constexpr Duration safe_once = milliseconds(500);
  static constexpr Duration safe_again = seconds(5);
  /// The time for which a host that has retried, or has an answer, keeps its place to continue.
  static constexpr Duration time_to_go_on = milliseconds(50);
  /// A host that has been silent for this long is removed, even if its place is not needed.
  static constexpr Duration idle_time = seconds(60);
  /// A sender that finds no place is remembered for at least this long, at most twice as long.
  /// Longer, new senders would be mistaken for earlier ones, because a machine reuses its ports.
  static constexpr Duration memory = seconds(1);
  /// The limit for remembered senders.
  static constexpr std::size_t most_remembered = 4096;

  struct Host {
    asio::ip::udp::endpoint endpoint{};
    std::size_t port{};
    Instant heard{};
    bool has_tried{};                   ///< it found no place before
    std::optional<Instant> answered{};  ///< when something was sent to it
    bool is_known{};                    ///< it has sent again after that

    /// The time of the last datagram from or to the host, which may only listen to a stream.
    Instant last() const { return std::max(heard, answered.value_or(heard)); }
  };

  explicit DatagramHosts(std::size_t places) : places_(places) {}

  std::size_t places() const { return places_; }
  bool is_full() const { return hosts_.size() >= places_; }
  const std::vector<Host>& all() const { return hosts_; }

  const Host* find(const asio::ip::udp::endpoint& endpoint) const {
    const auto found = std::find_if(hosts_.begin(), hosts_.end(),
                                    [&](const Host& host) { return host.endpoint == endpoint; });
    return found == hosts_.end() ? nullptr : &*found;
  }

  /// Precondition: not full, and the endpoint is not a host yet.
  const Host& add(const asio::ip::udp::endpoint& endpoint, std::size_t port, Instant now) {
    return hosts_.emplace_back(Host{endpoint, port, now, has_tried(endpoint), {}, {}});
  }

  /// Records another datagram from a known host.
  void hear(const asio::ip::udp::endpoint& endpoint, Instant now) {
    for (Host& host : hosts_) {
      if (host.endpoint != endpoint) continue;
      host.heard = now;
      host.is_known = host.answered.has_value();
    }
  }

  /// Records that something was sent to a host.
  void answer(const asio::ip::udp::endpoint& endpoint, Instant now) {
    for (Host& host : hosts_) {
      if (host.endpoint == endpoint) host.answered = now;
    }
  }

  /// Removes the host that this sender replaces; returns nothing if all places are reserved.
  std::optional<Host> make_room(const asio::ip::udp::endpoint& endpoint, Instant now) {
    const bool tries_again = has_tried(endpoint);
    auto replaced = remove_first([&](const Host& host) {
      const Duration silent = now - host.heard;
      // It may be listening to a stream.
      if (host.is_known) return silent >= safe_again && now - *host.answered >= safe_again;
      if (!tries_again) return now - host.last() >= safe_once;
      return silent >= time_to_go_on || (!host.has_tried && !host.answered);
    });
    remember(replaced ? replaced->endpoint : endpoint, now);
    return replaced;
  }

  /// Removes the host at this port, if any.
  std::optional<Host> remove(std::size_t port) {
    return remove_first([&](const Host& host) { return host.port == port; });
  }

  /// Removes a host that has been silent for too long, if any.
  std::optional<Host> forget(Instant now) {
    return remove_first([&](const Host& host) { return now - host.heard >= idle_time; });
  }

 private:
  /// True for a sender that was refused or replaced.
  bool has_tried(const asio::ip::udp::endpoint& endpoint) const {
    return recent_.contains(endpoint) || earlier_.contains(endpoint);
  }

  void remember(const asio::ip::udp::endpoint& endpoint, Instant now) {
    if (recent_.size() >= most_remembered || now - since_ >= memory) {
      earlier_ = std::exchange(recent_, {});
      since_ = now;
    }
    recent_.insert(endpoint);
  }

  template <class Matches>
  std::optional<Host> remove_first(Matches&& matches) {
    auto first = hosts_.end();
    for (auto host = hosts_.begin(); host != hosts_.end(); ++host) {
      if (matches(*host) && (first == hosts_.end() || has_priority(*host, *first))) first = host;
    }
    if (first == hosts_.end()) return std::nullopt;
    const Host removed = *first;
    hosts_.erase(first);
    return removed;
  }

  static bool has_priority(const Host& one, const Host& other) {
    return one.is_known == other.is_known ? one.last() < other.last() : other.is_known;
  }

  std::size_t places_;
  std::vector<Host> hosts_{};
  std::set<asio::ip::udp::endpoint> recent_{};  // senders without a place, since since_
  std::set<asio::ip::udp::endpoint> earlier_{};
  Instant since_{};
};

}  // namespace sbgc::hosts
