/// The line between a host and an emulated board, with the faults of real ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/emulator/uart.hpp>
#include <sbgc/line.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

/// A period in which the line carries nothing.
struct Silence {
  Duration from{};  ///< since the beginning of the line
  Duration length{};
};

/// What goes wrong on a line. Shares are 0..1, of bytes unless said otherwise; in both directions.
struct Faults {
  double bit_errors = 0;  ///< of data bits
  double lost = 0;
  double duplicated = 0;
  double delayed = 0;  ///< the byte arrives `delay` later, and those after it no earlier
  Duration delay = milliseconds(20);
  /// Interval of text lines between frames of the board; 0: none.
  Duration text_every{};
  std::vector<Silence> silences{};
};

struct LineOptions {
  /// The board's rate and parity. Rate 0: bytes take no time, and the host's settings do not
  /// matter, as over USB.
  LineSettings board{};
  /// The board adopts the parity of the host, as boards do since firmware 2.41.
  bool detects_parity = true;
  Faults faults{};
  std::uint32_t seed = 1;
};

/// What a line did to the bytes on it.
struct LineCounters {
  std::uint64_t bytes{};          ///< put on the line by the sender
  std::uint64_t bit_errors{};     ///< flipped bits
  std::uint64_t parity_errors{};  ///< bytes dropped because bit errors made their parity wrong
  std::uint64_t lost{};
  std::uint64_t duplicated{};
  std::uint64_t delayed{};
  std::uint64_t silenced{};    ///< bytes lost in silences
  std::uint64_t mismatched{};  ///< bytes sent while the settings of the ends differed
  std::uint64_t text_lines{};

  bool operator==(const LineCounters&) const = default;
};

/// One direction of a line: bytes enter at one end and leave at the other, later.
///
/// Deterministic: the same bytes sent at the same times meet the same faults and arrive at the same
/// times, however they are split and however often receive() is called. Times must not decrease.
class Line {
 public:
  enum class Way : std::uint8_t { to_board, to_host };

  /// Size of the sender's UART buffer at a limited rate; further bytes wait with the sender. An
  /// assumption.
  static constexpr std::size_t fifo_size = 16;

  /// Silences and text lines count from `beginning`; the host connects at `now`. Precondition:
  /// shares are 0..1, no time is negative.
  Line(const LineOptions& options, Way way, Instant beginning, Instant now);

  /// The settings of the host's serial port; empty or a rate of 0: those of the board. While they
  /// differ, bytes become the garbage that a UART makes of them. Applies to what is sent from now
  /// on.
  void set_host(const std::optional<LineSettings>& settings);
  /// The board has other settings from now on.
  void set_board(const LineSettings& settings);

  void send(std::span<const std::uint8_t> bytes, Instant now);
  /// Free space in the sender's UART buffer. send() accepts more and queues it.
  std::size_t room(Instant now) const;
  /// When half of the UART's buffer is free.
  Instant ready() const;

  /// Appends the bytes that have arrived up to now to `into`.
  void receive(Instant now, std::vector<std::uint8_t>& into);
  /// Skips the text lines that are due by now: there is no room for them.
  void leave_out_text(Instant now);
  /// No more text lines.
  void end_text() { text_due_.reset(); }
  /// The sender lost the rest of the frame that it was sending.
  void break_off_frame() { frame_bytes_ = 0; }
  /// When receive() next has something to do; Instant::never if only send() can change that.
  Instant next() const;
  /// Bytes that have been sent and not received; at a limited rate also lost ones, for as long as
  /// they take.
  std::size_t under_way() const { return arrivals_.size(); }

  const LineCounters& counters() const { return counters_; }

 private:
  /// Each kind has its own random numbers.
  enum class Fault : std::uint8_t { bit_error, loss, duplicate, delay, text };

  struct Arrival {
    Instant at{};
    std::optional<std::uint8_t> byte{};  // empty: the time of a lost byte
  };

  void settings_changed();
  /// When the first `bits` bits of the run have been sent, rounded up.
  Instant time_of(std::uint64_t bits) const;
  /// Begins the next byte, now or after the last one.
  void begin_byte(Instant now);
  void put(std::uint8_t byte, Instant now);
  void put_with_faults(std::uint8_t byte, Instant now);
  /// The levels of a byte or, if it is lost, of an idle line.
  void put_levels(std::uint8_t byte, std::uint8_t flips, bool is_carried, Duration delay);
  void hear(bool level, Duration delay);
  void hear_idle(Instant until);
  void arrive(std::optional<std::uint8_t> byte, Instant at);
  bool is_text_due(Instant now) const;
  /// Schedules the next text line after that time; earlier ones are skipped.
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
  Duration byte_delay_{};               // of what the UART receives

  // Bytes without a pause between them are a run: times are counted from its beginning, so that
  // rounding never adds up. Of a line without a rate: each byte is a run.
  Instant run_{};
  std::uint64_t run_bits_ = 0;

  Instant handed_over_;  // last send()
  std::optional<Instant> text_due_{};
  std::size_t frame_bytes_ = 0;  // of the frame that is being sent; 0: between frames
  std::size_t frame_size_ = 0;
  std::deque<Arrival> arrivals_{};
  Instant last_arrival_;
  LineCounters counters_{};
};

}  // namespace sbgc::emulator
