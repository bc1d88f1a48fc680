// Fuzzes sessions with any schedule of requests, bytes and time. The input starts with the
// options, followed by steps, each an opcode byte and its operands; see Player::step().
//
// Invariants: each request ends exactly once, events refer to open requests, one call of poll()
// writes at most one complete frame, and poll() always makes progress.

#include <set>
#include <type_traits>

#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>
#include <sbgc/visit.hpp>

#include "input.hpp"

namespace {

using sbgc::Event;
using sbgc::EventKind;
using sbgc::Handle;
using sbgc::Instant;
using sbgc::Outcome;
using sbgc::fuzz::require;

// Small capacities, so that every limit is reached.
using Session =
    sbgc::BasicSession<sbgc::SessionCapacity{.requests = 4, .late_replies = 5, .streams = 2}>;

/// The smallest session, for a microcontroller.
using SmallSession = sbgc::BasicSession<sbgc::SessionCapacity{
    .requests = 1, .late_replies = 1, .streams = 0, .optimize = sbgc::Optimize::size}>;

template <class Session>
class Player {
 public:
  explicit Player(std::span<const std::uint8_t> input) : input_(input), session_(options()) {}

  void play() {
    while (!input_.empty()) step();
    // Without responses, every request times out.
    for (int polls = 0; session_.open_requests() != 0; ++polls) {
      require(polls < 10'000);
      now_ = sbgc::later(now_, poll());
    }
    require(open_.empty());
    const sbgc::SessionStatistics statistics = session_.statistics();
    if (has_statistics) require(statistics.sent_frames == written_);
    require(statistics.retries <= statistics.timeouts);
  }

 private:
  struct Sink {
    Player* player;
    void operator()(const Event& event) const { player->take(event); }
  };
  Sink sink() { return {this}; }

  sbgc::SessionOptions options() {
    constexpr std::array<std::uint32_t, 4> rates{0, 9600, 115200, 1};
    sbgc::SessionOptions result;
    const std::uint8_t choice = input_.byte();
    result.line = {rates[choice & 3], (choice & 4) != 0 ? sbgc::Parity::even : sbgc::Parity::none};
    if ((choice & 8) != 0) result.pacing = {{}, {}};
    if ((choice & 16) != 0) result.duplicate_window = sbgc::milliseconds(50);
    if ((choice & 32) != 0) result.late = {};
    if ((choice & 64) != 0) result.idle = {};
    sink_calls_back_ = (choice & 128) != 0;
    return result;
  }

  void step() {
    const std::uint8_t code = input_.byte();
    switch (code % 12) {
      case 0:
      case 1: send(input_.byte()); break;
      case 2: session_.feed(input_.bytes(input_.byte()), now_, sink()); break;
      case 3: {  // any frame
        const std::uint8_t id = input_.byte();
        feed_frame(id, input_.bytes(input_.byte()));
        break;
      }
      case 4:
      case 5: answer(code >= 128); break;
      case 6: feed_frame(67, std::array{input_.byte()}); break;
      case 7: {  // errors and restarts
        const std::array<std::uint8_t, 6> body{input_.byte()};
        feed_frame(code < 128 ? 255 : 114, std::span(body).first(code & 1 ? 5 : 6));
        break;
      }
      case 8: now_ = now_ + sbgc::microseconds(std::int64_t{1} << (input_.byte() % 40)); break;
      case 9: now_ = now_ - sbgc::milliseconds(input_.byte()); break;
      case 10: now_ = poll(); break;
      default: cancel_something(code); break;
    }
    require(session_.open_requests() == open_.size());
    if (code >= 64) static_cast<void>(poll());
  }

  void cancel_something(std::uint8_t code) {
    if (code > 240) {
      session_.abandon(sink());
      require(open_.empty() || sink_calls_back_);
    } else if (!open_.empty()) {
      require(session_.cancel(*open_.begin(), sink()));
    } else {
      require(!session_.cancel(Handle{1'000'000}, sink()));
      session_.set_line({115200, sbgc::Parity::none});
    }
  }

  /// Sends any request of the protocol with a body from the input.
  void send(std::uint8_t id) {
    const std::uint8_t flags = input_.byte();
    sbgc::SendOptions options;
    options.expect_confirmation = (flags & 1) != 0;
    options.ignore_budget = (flags & 2) != 0;
    options.attempts = (flags >> 2) & 3;
    if ((flags & 16) != 0) options.timeout = sbgc::milliseconds(20);
    if ((flags & 32) != 0) options.deadline = now_ + sbgc::milliseconds(input_.byte());
    const auto body = input_.bytes(input_.byte());
    sbgc::visit(id, body, sbgc::Direction::to_board, [&](const auto& message) {
      if constexpr (requires { response_policy(message); }) {
        const sbgc::ResponsePolicy policy = response_policy(message);
        const auto send = [&] {
          if ((flags & 128) != 0) {
            return session_.try_framing(sbgc::framings.back(), id, body, policy, options);
          }
          return (flags & 64) != 0 ? session_.send(id, body, policy, options)
                                   : session_.send(message, options);
        };
        const sbgc::SendResult result = send();
        require(static_cast<bool>(result) == static_cast<bool>(result.handle));
        if (!result) return;
        require(open_.insert(result.handle).second);
        newest_ = policy.responses;
      }
    });
  }

  void feed_frame(std::uint8_t id, std::span<const std::uint8_t> body) {
    std::array<std::uint8_t, sbgc::max_frame_size> frame{};
    const std::size_t size = sbgc::write_frame(framing_, id, body, frame).size;
    session_.feed(std::span(frame).first(size), now_, sink());
  }

  /// Feeds a response that matches the newest request.
  void answer(bool last_form) {
    if (newest_.form_count == 0) {
      feed_frame(67, std::array{newest_.command});
      return;
    }
    const std::size_t index = last_form ? std::size_t{newest_.form_count} - 1 : 0;
    const sbgc::ResponseForm& form = newest_.forms[index];
    std::array<std::uint8_t, 255> body{};
    for (const sbgc::CorrelationField& field : form.correlation) {
      for (std::size_t i = 0; i < field.size; ++i) {
        body[field.offset + i] = static_cast<std::uint8_t>(field.value >> (8 * i));
      }
    }
    feed_frame(form.id, std::span(body).first(form.min_size));
  }

  Instant poll() {
    const sbgc::Output output = session_.poll(now_, sink());
    if (output.bytes.empty()) {
      require(output.deadline > now_);
      return output.deadline == Instant::never ? now_ : output.deadline;
    }
    if (++written_ % 2 == 0) session_.written(now_);
    std::size_t frames = 0;
    sbgc::ParserOfAll parser;
    parser.feed(output.bytes, [&](const sbgc::Frame& frame) {
      ++frames;
      framing_ = frame.framing;
    });
    require(frames == 1 && parser.counters().skipped_bytes == 0);
    return output.deadline < now_ || output.deadline == Instant::never ? now_ : output.deadline;
  }

  void take(const Event& event) {
    require((event.kind == EventKind::completed) == (event.outcome != Outcome::none));
    if (event.handle) require(open_.contains(event.handle));
    if (event.kind == EventKind::completed) {
      require(open_.erase(event.handle) == 1);
      if (sink_calls_back_ && lively_left_ > 0) {
        --lively_left_;
        send(86);
      }
    } else if (event.kind == EventKind::confirmation && event.handle) {
      require(event.confirmation != 0);
      if (sink_calls_back_ && (event.confirmation & 1) != 0) {
        require(session_.cancel(event.handle, sink()));
      }
    } else {
      require(event.frame.id != 0);
    }
  }

  static constexpr bool has_statistics = std::is_same_v<Session, ::Session>;

  sbgc::fuzz::Input input_;
  bool sink_calls_back_{};  // the sink sends and cancels requests
  int lively_left_ = 50;
  Session session_;
  Instant now_{};
  std::set<Handle> open_;
  sbgc::Responses newest_{};
  sbgc::Framing framing_ = sbgc::basic_framing;  // of the last written frame
  std::uint64_t written_{};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Player<Session>({data, size}).play();
  Player<SmallSession>({data, size}).play();
  return 0;
}
