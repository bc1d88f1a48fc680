/// An emulated line between host and board, with the faults of real lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/emulator/uart.hpp>
#include <sbgc/line.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

/// A period in which the line carries no data.
struct Silence {
  Duration from{};  ///< since the beginning of the line
  Duration length{};
};

/// Faults of a line, in both directions. Shares are 0..1, of bytes unless noted otherwise.
struct Faults {
  double bit_errors = 0;  ///< of data bits
  double lost = 0;        ///< the byte does not arrive
  double duplicated = 0;  ///< the byte arrives twice
  double delayed = 0;     ///< the byte arrives `delay` later, and later bytes no earlier than it
  Duration delay = milliseconds(20);  ///< of a delayed byte
  /// The interval of text lines between frames of the board; 0 means none.
  Duration text_every{};
  std::vector<Silence> silences{};
};

/// The serial line between host and board, with its faults.
struct LineOptions {
  /// The rate and parity of the board. With rate 0, bytes take no time and the host's settings have
  /// no effect, as over USB.
  LineSettings board{};
  /// The board adopts the parity of the host, as boards do since firmware 2.41.
  bool detects_parity = true;
  Faults faults{};
  std::uint32_t seed = 1;  ///< of the random numbers: the same seed gives the same faults
};

/// Counters of a line's traffic and faults.
struct LineCounters {
  std::uint64_t bytes{};          ///< sent by the sender
  std::uint64_t bit_errors{};     ///< flipped bits
  std::uint64_t parity_errors{};  ///< bytes dropped for a wrong parity after bit errors
  std::uint64_t lost{};           ///< bytes
  std::uint64_t duplicated{};     ///< bytes
  std::uint64_t delayed{};        ///< bytes
  std::uint64_t silenced{};       ///< bytes lost in silences
  std::uint64_t mismatched{};     ///< bytes sent while the settings of both ends differed
  std::uint64_t text_lines{};     ///< that the board sent between frames

  bool operator==(const LineCounters&) const = default;
};

/// One direction of a line. Bytes enter at one end and leave at the other, later.
///
/// Deterministic: the same bytes, sent at the same times, have the same faults and arrival times,
/// however they are split and however often receive() is called. Times must not decrease.
class Line {
 public:
  /// The direction of a line.
  enum class Way : std::uint8_t { to_board, to_host };

  /// The size of the sender's UART buffer at a limited rate; further bytes wait with the sender.
  /// Assumption.
  static constexpr std::size_t fifo_size = 16;

  /// Silences and text lines count from `beginning`; the host connects at `now`. Precondition:
  /// shares are 0..1, and times are not negative.
  Line(const LineOptions& options, Way way, Instant beginning, Instant now);

  /// The settings of the host's serial port; without a value or with rate 0, those of the board.
  /// While the settings differ, the receiver gets the garbage that a UART would produce. Applies to
  /// bytes sent from now on.
  void set_host(const std::optional<LineSettings>& settings);
  /// Changes the settings of the board from now on.
  void set_board(const LineSettings& settings);

  /// Replaces the faults, for bytes sent from now on.
  void set_faults(const Faults& faults, Instant now);

  /// Accepts bytes from the sender.
  void send(std::span<const std::uint8_t> bytes, Instant now);
  /// Free space in the sender's UART buffer. send() accepts more and queues it.
  std::size_t room(Instant now) const;
  /// The time at which half of the UART buffer is free.
  Instant ready() const;

  /// Appends the bytes that have arrived until `now` to `into`.
  void receive(Instant now, std::vector<std::uint8_t>& into);
  /// Skips the text lines that are due until `now`, because there is no room for them.
  void skip_text(Instant now);
  /// Ends the text lines.
  void end_text() { text_due_.reset(); }
  /// Reports that the sender dropped the rest of the current frame.
  void abort_frame() { frame_bytes_ = 0; }
  /// The next time at which receive() has something to do; Instant::never if that depends on
  /// send().
  Instant next() const;
  /// The number of bytes sent but not received; at a limited rate this includes lost bytes for the
  /// time they take.
  std::size_t under_way() const { return arrivals_.size(); }

  /// Returns the counters since the line was made.
  const LineCounters& counters() const { return counters_; }

 private:
  /// Each fault has its own random numbers.
  enum class Fault : std::uint8_t { bit_error, loss, duplicate, delay, text };

  struct Arrival {
    Instant at{};
    std::optional<std::uint8_t> byte{};  // empty for the time of a lost byte
  };

  void settings_changed();
  /// The time at which the first `bits` bits of the run have been sent, rounded up.
  Instant time_of(std::uint64_t bits) const;
  /// Starts the next byte, now or after the previous one.
  void begin_byte(Instant now);
  void put(std::uint8_t byte, Instant now);
  void put_with_faults(std::uint8_t byte, Instant now);
  /// Sends the levels of a byte, or of an idle line if the byte is lost.
  void put_levels(std::uint8_t byte, std::uint8_t flips, bool is_carried, Duration delay);
  void hear(bool level, Duration delay);
  void hear_idle(Instant until);
  void arrive(std::optional<std::uint8_t> byte, Instant at);
  bool is_text_due(Instant now) const;
  /// Schedules the next text line after this time and skips earlier ones.
  void plan_text(Instant after);
  /// Sends the text lines that are due.
  void put_text(Instant until);
  void follow_frame(std::uint8_t byte);
  bool is_silent(Instant from, Instant until) const;
  bool happens(Fault fault, double share, std::uint64_t number) const;
  std::uint64_t seed(Fault fault) const;

  LineOptions options_;
  Way way_;
  Instant beginning_;
  std::optional<LineSettings> host_{};
  LineSettings sender_{};
  std::optional<UartReceiver> uart_{};  // while the settings differ
  Duration byte_delay_{};               // of bytes that the UART receives

  // A run is a sequence of bytes without a pause. Times count from its beginning so that rounding
  // errors do not add up. On a line without a rate, each byte is a run.
  Instant run_{};
  std::uint64_t run_bits_ = 0;

  Instant handed_over_;  // time of the last send()
  std::optional<Instant> text_due_{};
  std::size_t frame_bytes_ = 0;  // bytes of the current frame; 0 between frames
  std::size_t frame_size_ = 0;
  Framing framing_{};
  std::deque<Arrival> arrivals_{};
  Instant last_arrival_;
  LineCounters counters_{};
};

}  // namespace sbgc::emulator
