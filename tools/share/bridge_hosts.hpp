/// The hosts of a bridge, without I/O: their places, their stops, and which answers are theirs.
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

/// A stop is done when the board has reported speed 0 for half a second, motors off when the board
/// has confirmed it. Motion that any host commands later ends both.
class HostStops {
 public:
  static constexpr Duration rest = sbgc::milliseconds(500);

  void asked(std::size_t port, std::uint64_t tag, const RawRequest& request);
  /// A frame has answered the request.
  void answered(std::uint64_t tag, const Frame& frame);
  /// Every frame of the board.
  void arrived(const Frame& frame, Instant now);
  /// The host has left: returns what it has commanded and what is not done.
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

/// A host that has asked the board, and the framing of its request.
struct RequestOwner {
  std::size_t port{};
  Framing framing = basic_framing;
};

/// Knows who has asked for what, to tell whose a frame is that the line has matched to no request:
/// most confirmations and errors come when nobody waits for them any more, because the next request
/// must not wait for what may never come.
///
/// Such a frame answers the oldest request without an answer, because the board answers in order;
/// without one, it confirms the end of the last task that has begun. Without a task, it answers the
/// request that was answered a moment ago, because some have several answers. An answer that comes
/// much too late goes to the host that has asked, or to nobody if several have.
class RequestOwners {
 public:
  /// An answer can be so late, after the time that the policy of its request allows.
  static constexpr Duration lateness = sbgc::milliseconds(500);
  /// So long after its request, a frame is an answer, even if it is not known to whom.
  static constexpr Duration memory = sbgc::seconds(60);
  /// How many requests are remembered.
  static constexpr std::size_t most = 4096;

  /// A request is sent. Tags increase.
  void asked(std::uint64_t tag, const RequestOwner& asker, const RawRequest& request, Instant now);
  /// A frame has answered it.
  void answered(std::uint64_t tag, const Frame& frame, Instant now);
  /// The line waits no longer for the request, which has, or has not, `timed_out`.
  void ended(std::uint64_t tag, bool timed_out, Instant now);
  /// It was not sent.
  void withdrawn(std::uint64_t tag);
  /// The host has left. Its answers are nobody's.
  void left(std::size_t port);

  /// True if the board may still answer a request of the host.
  bool awaits_answer(std::size_t port, Instant now) const;

  struct Claim {
    bool is_answer = false;               ///< else nobody has asked for it
    bool is_awaited = false;              ///< it is the answer to a request without one
    std::optional<RequestOwner> asker{};  ///< if it is known, and has not left
  };
  /// Tells whose a frame is, and counts it as an answer.
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
    Instant due = Instant::never;  // when an answer, or a further one, is too late

    bool is_due(Instant now) const { return missing != 0 && now < due; }
    bool can_be_answered_by(const Frame& frame) const;
    void take(const Frame& frame, Instant now);
  };

  Entry* find(std::uint64_t tag);
  static bool is_same_host(const Entry& one, const Entry& other);

  std::deque<Entry> entries_;  // from the oldest
};

}  // namespace sbgc::tools
