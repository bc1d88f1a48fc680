/// Detection of the baud rate and parity of a board, without I/O: the caller passes in time and
/// bytes and gets back the next step.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <sbgc/frame.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/line.hpp>
#include <sbgc/line_facts.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/time.hpp>

namespace sbgc {

/// Options of a detection. A line here is a combination of baud rate and parity.
struct DetectorOptions {
  std::uint8_t rounds = 3;  ///< visits of each line; each waits longer than the previous one
  std::uint8_t probes = 2;  ///< requests per visit
  /// Further requests per visit on a line where the board sends frames, but has not answered.
  std::uint8_t more_probes = 3;
  Duration settle = milliseconds(10);  ///< between setting a line and the first request
  /// The timeout of a response in the first round, excluding its time on the line; n times that in
  /// round n.
  Duration response_timeout = milliseconds(60);
  /// The frame that requests the board's introduction, if not the usual one: a port may require a
  /// password. Must outlive the detector.
  std::span<const std::uint8_t> question{};
};

/// The attempts on one line, and their results.
struct Trial {
  LineSettings line{};          ///< the settings
  std::uint16_t probes{};       ///< requests sent
  std::uint32_t bytes{};        ///< received
  std::uint32_t good_frames{};  ///< received, including the introduction
  std::uint32_t bad_frames{};   ///< candidates with a wrong checksum
  bool is_refused{};            ///< the port does not support these settings
};

/// The action that the caller must take before it calls next() again.
struct DetectorStep {
  /// The next action.
  enum class Kind : std::uint8_t {
    set_line,  ///< change to `line` and discard bytes received before, or call refuse()
    write,     ///< write `bytes`
    wait,      ///< wait until `until` or until bytes arrive
    found,     ///< done: `line` is correct, and introduction() is available
    failed,    ///< done: there is no board, or it does not answer; see trials()
  };
  Kind kind{};
  LineSettings line{};                    ///< of `set_line` and `found`
  std::span<const std::uint8_t> bytes{};  ///< of `write`, valid until the next call
  Instant until = Instant::never;         ///< of `wait`
};

/// Requests the introduction of a board at every baud rate and parity in use, the most likely
/// first, until the board answers.
///
/// Visits every line once, quickly; then again, with longer timeouts. Ends after the second round
/// if no byte has been received. Ignores and counts garbage.
///
/// No heap, no clock. A Detector takes about 1.6 KB.
class Detector {
 public:
  /// The number of lines to try.
  static constexpr std::size_t lines = baud_rates.size() * parities.size();

  /// Begins with the first trial.
  constexpr explicit Detector(const DetectorOptions& options = {}) noexcept : options_(options) {
    if (options_.question.empty()) options_.question = usual_question;
    // All rates named in the protocol come first, with any parity.
    std::size_t next = 0;
    for (const bool named : {true, false}) {
      for (const Parity parity : parities) {
        for (std::size_t i = 0; i < baud_rates.size(); ++i) {
          if ((i < named_baud_rates) == named) trials_[next++].line = {baud_rates[i], parity};
        }
      }
    }
    if (trials_.empty() || options_.rounds == 0) phase_ = Phase::failed;
  }

  /// Returns the next step.
  DetectorStep next(Instant now) noexcept {
    now_ = later(now_, now);
    if (phase_ == Phase::set_line) {
      phase_ = Phase::settle;
      until_ = now_ + options_.settle;
      probes_ = 0;
      was_heard_ = false;
      parser_.reset();
      return step(DetectorStep::Kind::set_line);
    }
    if (phase_ == Phase::settle && until_ <= now_) return probe();
    if (phase_ == Phase::listen && until_ <= now_) {
      parser_.flush([this](const Frame& frame) { take(frame); });
      count_bad_frames();
      if (phase_ == Phase::listen) {
        if (probes_ < options_.probes + (was_heard_ ? options_.more_probes : 0)) return probe();
        leave_line();
        return next(now);
      }
    }
    switch (phase_) {
      case Phase::found: return step(DetectorStep::Kind::found);
      case Phase::failed: return {.kind = DetectorStep::Kind::failed};
      default: {
        DetectorStep result = step(DetectorStep::Kind::wait);
        result.until = until_;
        return result;
      }
    }
  }

  /// Processes received bytes; call next() afterwards.
  void feed(std::span<const std::uint8_t> bytes) noexcept {
    if (phase_ == Phase::found || phase_ == Phase::failed || phase_ == Phase::set_line) return;
    trial().bytes += static_cast<std::uint32_t>(bytes.size());
    parser_.feed(bytes, [this](const Frame& frame) { take(frame); });
    count_bad_frames();
  }

  /// Rejects the settings of the last step, which the port does not support. They are not tried
  /// again.
  void refuse() noexcept {
    if (phase_ != Phase::settle) return;
    trial().is_refused = true;
    leave_line();
  }

  /// Returns the introduction of the board; id 0 before it is found. A view into this object.
  Frame introduction() const noexcept {
    if (phase_ != Phase::found) return {};
    return {introduction_id_, {introduction_.data(), introduction_size_}, 0};
  }

  /// Returns the lines in the order in which they are tried.
  std::span<const Trial, lines> trials() const noexcept { return trials_; }

 private:
  enum class Phase : std::uint8_t { set_line, settle, listen, found, failed };

  static constexpr auto usual_question = [] {
    std::array<std::uint8_t, frame_size(0)> frame{};
    static_cast<void>(write_frame(roles::introduction_request_id, {}, frame));
    return frame;
  }();

  Trial& trial() noexcept { return trials_[current_]; }

  DetectorStep step(DetectorStep::Kind kind) noexcept {
    return {.kind = kind, .line = trial().line};
  }

  DetectorStep probe() noexcept {
    phase_ = Phase::listen;
    ++probes_;
    ++trial().probes;
    const std::size_t bytes = options_.question.size() + frame_size(roles::introduction_size);
    until_ = now_ + wire_time(trial().line, bytes) + options_.response_timeout * (round_ + 1);
    DetectorStep result = step(DetectorStep::Kind::write);
    result.bytes = options_.question;
    return result;
  }

  void take(const Frame& frame) noexcept {
    if (phase_ == Phase::found) return;
    ++trial().good_frames;
    was_heard_ = true;
    if (!roles::is_introduction(frame)) return;
    introduction_id_ = frame.id;
    introduction_size_ = frame.body.size();
    detail::copy_memory(introduction_.data(), frame.body.data(), frame.body.size());
    phase_ = Phase::found;
  }

  /// Adds the errors that the parser has counted since the last call.
  void count_bad_frames() noexcept {
    const ParserCounters counters = parser_.counters();
    const std::uint64_t bad = counters.header_errors + counters.body_errors;
    trial().bad_frames += static_cast<std::uint32_t>(bad - bad_counted_);
    bad_counted_ = bad;
  }

  void leave_line() noexcept {
    phase_ = Phase::set_line;
    bad_counted_ = 0;
    do {
      if (++current_ == lines) {
        current_ = 0;
        ++round_;
        if (round_ >= options_.rounds || (round_ == 2 && is_silent())) {
          phase_ = Phase::failed;
          return;
        }
      }
    } while (trial().is_refused);
  }

  bool is_silent() const noexcept {
    // NOLINTNEXTLINE(readability-use-anyofallof): no <algorithm> here
    for (const Trial& trial : trials_) {
      if (trial.bytes != 0) return false;
    }
    return true;
  }

  DetectorOptions options_;
  Parser parser_{};
  Phase phase_{};
  bool was_heard_{};  // since the line was set
  std::uint8_t round_{};
  std::uint8_t probes_{};  // since the line was set
  std::size_t current_{};
  Instant now_{std::numeric_limits<std::int64_t>::min()};
  Instant until_{};
  std::uint64_t bad_counted_{};
  std::array<Trial, lines> trials_{};
  std::uint8_t introduction_id_{};
  std::size_t introduction_size_{};
  std::array<std::uint8_t, max_body_size> introduction_{};
};

static_assert(sizeof(Detector) <= 2048, "a detector must fit into a small microcontroller");

}  // namespace sbgc
