/// The hosts of a bridge, without I/O: their places, their stops, and the assignment of answers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include <sbgc/client/raw_request.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/time.hpp>

#include "move/owed_stop.hpp"

namespace sbgc::tools {

/// If all places are taken, a newcomer replaces a host that has never sent a whole frame, or else
/// the one that has been silent longest. One more place is reserved for a newcomer that finds none:
/// for a while, it can stop the camera and observe that. Others are told that there is no place.
class HostPlaces {
 public:
  static constexpr std::size_t max_hosts = 32;
  /// Includes the reserved place, hosts without a place, and leaving hosts, for which the endpoints
  /// need a moment.
  static constexpr std::size_t max_ports = 3 * max_hosts;
  /// A host that has sent no whole frame within this time after connecting may be replaced; so may
  /// the host at the reserved place. A host without a place must leave.
  static constexpr Duration time_to_speak = sbgc::seconds(2);
  /// A host that has neither sent nor received anything for this long may be replaced.
  static constexpr Duration longest_silence = sbgc::seconds(10);
  static constexpr Duration reserved_time = sbgc::seconds(15);

  /// Returns since when a host has neither sent nor received; Instant::never if it is busy.
  using SilentSince = std::function<Instant(std::size_t port)>;

  struct Arrival {
    bool is_heard{};  ///< otherwise it must leave at once
    std::optional<std::size_t> replaced{};
  };
  Arrival come(std::size_t port, Instant now, const SilentSince& silent_since);
  /// Marks a host that is not replaced, and needs no free place: a terminal, which stays.
  void keep(std::size_t port) { hosts_[port].place = Place::kept; }
  /// The host gives up its place, and keeps its port for a moment.
  void give_up(std::size_t port) { hosts_[port].place = Place::leaving; }
  void leave(std::size_t port) { hosts_.erase(port); }

  /// Records that the host has sent a whole frame.
  void speak(std::size_t port) { hosts_[port].has_spoken = true; }
  /// Returns false for a request that is not served at its place.
  bool serves(std::size_t port, const RawRequest& request);
  bool has_none(std::size_t port) const { return hosts_.at(port).place == Place::none; }
  /// Returns the ports of hosts whose time is over.
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

/// Tracks stops. A stop is done when the board has reported speed 0 for half a second, motors off
/// when the board has confirmed it. Later motion of any host ends both.
class HostStops {
 public:
  static constexpr Duration rest = sbgc::milliseconds(500);

  void asked(std::size_t port, std::uint64_t tag, const RawRequest& request);
  /// Reports that a frame has answered the request.
  void answered(std::uint64_t tag, const Frame& frame);
  /// Must be called with every frame of the board.
  void arrived(const Frame& frame, Instant now);
  /// Reports that the host has left; returns its stops that are not done.
  std::vector<OwedStop> left(std::size_t port);

 private:
  struct Debt {
    std::size_t port{};
    std::uint64_t tag{};
    OwedStop owed{};
  };

  std::vector<Debt> debts_{};
  Instant still_since_ = Instant::never;
};

/// A host that has sent a request, and the framing of the request.
struct RequestOwner {
  std::size_t port{};
  Framing framing = basic_framing;
};

/// Tracks the senders of requests, to assign frames that the line has matched to no request: most
/// confirmations and errors arrive when they are no longer awaited, because the next request must
/// not wait for optional responses.
///
/// Such a frame answers the oldest request without an answer, because the board answers in order;
/// without one, it confirms the end of the last task that has begun. Without a task, it answers the
/// request that was answered a moment ago, because some have several answers. An answer that is
/// much too late goes to the host that has sent the request, or to nobody if several have.
class RequestOwners {
 public:
  /// The maximum delay of an answer, beyond the time that the policy of its request allows.
  static constexpr Duration lateness = sbgc::milliseconds(500);
  /// For this long after its request, a frame is an answer, even if its receiver is unknown.
  static constexpr Duration memory = sbgc::seconds(60);
  /// The maximum number of remembered requests.
  static constexpr std::size_t most = 4096;

  /// Records that a request is sent. Tags increase.
  void asked(std::uint64_t tag, const RequestOwner& asker, const RawRequest& request, Instant now);
  /// Records that a frame has answered it.
  void answered(std::uint64_t tag, const Frame& frame, Instant now);
  /// Records that the line no longer waits for the request, which has or has not `timed_out`.
  void ended(std::uint64_t tag, bool timed_out, Instant now);
  /// Records that it was not sent.
  void withdrawn(std::uint64_t tag);
  /// Records that the host has left. Its answers go to nobody.
  void left(std::size_t port);

  /// True if the board may still answer a request of the host.
  bool awaits_answer(std::size_t port, Instant now) const;

  struct Claim {
    bool is_answer = false;               ///< otherwise nobody has requested it
    bool is_awaited = false;              ///< it is the answer to a request without one
    std::optional<RequestOwner> asker{};  ///< if it is known, and has not left
  };
  /// Returns the receiver of a frame, and counts it as an answer.
  Claim claim(const Frame& frame, Instant now);

 private:
  struct Entry {
    std::uint64_t tag{};
    std::optional<RequestOwner> asker{};
    Responses responses{};
    unsigned missing{};    // answers
    unsigned confirmed{};  // how often
    Duration patience{};
    Instant at{};
    Instant due = Instant::never;  // the deadline of an answer, or of a further one

    bool is_due(Instant now) const { return missing != 0 && now < due; }
    bool can_be_answered_by(const Frame& frame) const;
    void take(const Frame& frame, Instant now);
  };

  Entry* find(std::uint64_t tag);
  static bool is_same_host(const Entry& one, const Entry& other);

  std::deque<Entry> entries_;  // from the oldest
};

}  // namespace sbgc::tools
