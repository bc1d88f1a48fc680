/// The hosts that send datagrams, and their eviction.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <asio/ip/udp.hpp>

#include <sbgc/time.hpp>

namespace sbgc::serving {

/// UDP does not report that a sender has left, and anyone can send from any number of addresses.
/// Therefore the number of places is limited, and a new host replaces the one that has been silent
/// longest: among those that sent only one datagram, or else among all.
class DatagramHosts {
 public:
  /// How long a place is reserved after the first datagram and after each later one.
  static constexpr Duration safe_once = milliseconds(500);
  static constexpr Duration safe_again = seconds(5);
  /// A host that has been silent for this long is removed, even if its place is not needed.
  static constexpr Duration idle_time = seconds(60);

  struct Host {
    asio::ip::udp::endpoint endpoint{};
    std::size_t port{};
    Instant heard{};
    bool is_known{};  ///< true if it has sent more than one datagram
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
    return hosts_.emplace_back(Host{endpoint, port, now, false});
  }

  /// Records another datagram from a known host.
  void hear(const asio::ip::udp::endpoint& endpoint, Instant now) {
    for (Host& host : hosts_) {
      if (host.endpoint != endpoint) continue;
      host.heard = now;
      host.is_known = true;
    }
  }

  /// Removes the host to be replaced; returns nothing if all places are reserved. A known host may
  /// be listening to a stream, so it stays while there is an unknown one.
  std::optional<Host> make_room(Instant now) {
    const bool all_known = std::ranges::all_of(hosts_, &Host::is_known);
    return remove_first([&](const Host& host) {
      const Duration safe = host.is_known ? safe_again : safe_once;
      return host.is_known == all_known && now - host.heard >= safe;
    });
  }

  /// Removes a host that has been silent for too long, if any.
  std::optional<Host> forget(Instant now) {
    return remove_first([&](const Host& host) { return now - host.heard >= idle_time; });
  }

 private:
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
    return one.is_known == other.is_known ? one.heard < other.heard : other.is_known;
  }

  std::size_t places_;
  std::vector<Host> hosts_{};
};

}  // namespace sbgc::serving
