/// Tells to which host an answer of the board belongs.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include <sbgc/client/raw_request.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/time.hpp>

namespace sbgc::tools {

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
