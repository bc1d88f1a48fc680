/// The places of a bridge and the hosts that have them, without I/O.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include <sbgc/client/raw_request.hpp>
#include <sbgc/time.hpp>

namespace sbgc::tools {

/// If all places are taken, a newcomer replaces a host that has never sent a whole frame, or else
/// the one that has been silent longest. One place more is reserved for a newcomer that finds none:
/// it can stop the camera and see that, for a while. Others learn that there is no place.
class HostPlaces {
 public:
  static constexpr std::size_t max_hosts = 32;
  /// With the reserved place, those without a place, and those that leave, for whom the endpoints
  /// need a moment.
  static constexpr std::size_t max_ports = 3 * max_hosts;
  /// A host that has sent no whole frame so long after it came may be replaced; so may that at the
  /// reserved place. One without a place must leave.
  static constexpr Duration time_to_speak = sbgc::seconds(2);
  /// A host that has sent nothing and was sent nothing for so long may be replaced.
  static constexpr Duration longest_silence = sbgc::seconds(10);
  static constexpr Duration reserved_time = sbgc::seconds(15);

  /// Since when a host has sent nothing and was sent nothing; Instant::never if it is busy.
  using SilentSince = std::function<Instant(std::size_t port)>;

  struct Arrival {
    bool is_heard{};  ///< else it must go at once
    std::optional<std::size_t> replaced{};
  };
  Arrival come(std::size_t port, Instant now, const SilentSince& silent_since);
  /// The host is not replaced, and needs no free place. For a terminal, which stays.
  void keep(std::size_t port) { hosts_[port].place = Place::kept; }
  /// The host gives its place up, and keeps its port for a moment.
  void give_up(std::size_t port) { hosts_[port].place = Place::leaving; }
  void leave(std::size_t port) { hosts_.erase(port); }

  /// The host has sent a whole frame.
  void speak(std::size_t port) { hosts_[port].has_spoken = true; }
  /// Returns false for a request that its place does not serve.
  bool serves(std::size_t port, const RawRequest& request);
  bool has_none(std::size_t port) const { return hosts_.at(port).place == Place::none; }
  /// The places whose time is over.
  std::vector<std::size_t> overdue(Instant now) const;

 private:
  enum class Place { usual, kept, reserved, none, leaving };
  struct Host {
    Place place{};
    Instant came{};
    bool has_spoken{};
    bool has_stopped{};  // at the reserved place
  };

  std::optional<std::size_t> silent_host(Instant now, const SilentSince& silent_since) const;

  std::map<std::size_t, Host> hosts_{};  // by port
};

}  // namespace sbgc::tools
