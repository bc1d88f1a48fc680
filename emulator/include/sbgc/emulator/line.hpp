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

/// A length of time in which the line carries nothing.
struct Silence {
  Duration from{};  ///< since the beginning of the line
  Duration length{};
};

/// What goes wrong on a line. Shares are 0..1, of bytes unless said otherwise; in both directions.
struct Faults {
  double bit_errors = 0;  ///< of data bits
  double lost = 0;
  double duplicated = 0;
  double delayed = 0;  ///< the byte comes `delay` later, and those behind it not before it
  Duration delay = milliseconds(20);
  /// Text lines between frames of the board, so often; 0: never.
  Duration text_every{};
  std::vector<Silence> silences{};
};

struct LineOptions {
  /// The board's rate and parity: bytes take their time. Rate 0: they take none, and the host's
  /// settings do not matter, as over USB.
  LineSettings board{};
  /// The board takes to the parity of the host, as boards do from firmware 2.41 on.
  bool detects_parity = true;
  Faults faults{};
  std::uint32_t seed = 1;
};

/// What a line has done to what went over it.
struct LineCounters {
  std::uint64_t bytes{};          ///< put on the line by the sender
  std::uint64_t bit_errors{};     ///< bits turned over
  std::uint64_t parity_errors{};  ///< bytes dropped because bit errors made their parity wrong
  std::uint64_t lost{};
  std::uint64_t duplicated{};
  std::uint64_t delayed{};
  std::uint64_t silenced{};    ///< bytes lost in silences
  std::uint64_t mismatched{};  ///< bytes sent while the settings of the ends differed
  std::uint64_t text_lines{};

  bool operator==(const LineCounters&) const = default;
};

/// One direction of a line: bytes go in at one end and come out at the other, later.
///
/// Deterministic: the same bytes handed over at the same times meet the same faults and arrive at
/// the same times, however they are cut and however often arrivals are taken. Times must not
/// decrease.
class Line {
 public:
  enum class Way : std::uint8_t { to_board, to_host };

  /// Bytes that the sender's UART holds at a limited rate; what is behind them waits with the
  /// sender. Ours.
  static constexpr std::size_t fifo_size = 16;

  /// `beginning` is where silences and the times of text lines are counted from, `now` when
  /// somebody has connected to the line. Precondition: shares are 0..1, no time is negative.
  Line(const LineOptions& options, Way way, Instant beginning, Instant now);

  /// What the host's serial port is set to; none or a rate of 0: the same as the board. While they
  /// differ, bytes become the garbage that a UART makes of them. Counts for what is sent from now.
  void set_host(const std::optional<LineSettings>& settings);
  /// The board has other settings from now on.
  void set_board(const LineSettings& settings);

  void send(std::span<const std::uint8_t> bytes, Instant now);
  /// How many bytes the sender's UART has room for. send() takes more, which then queue.
  std::size_t room(Instant now) const;
  /// From when on half of the UART's buffer is free.
  Instant ready() const;

  /// Appends the bytes that have arrived up to now to `into`.
  void receive(Instant now, std::vector<std::uint8_t>& into);
  /// Text lines that would be put on the line by now are left out instead: there is no room for
  /// them.
  void leave_out_text(Instant now);
  /// No more text lines.
  void end_text() { text_due_.reset(); }
  /// The sender has lost the rest of the frame that it was sending.
  void break_off_frame() { frame_bytes_ = 0; }
  /// When receive() has something to do, Instant::never if only after send().
  Instant next() const;
  /// Bytes that have been sent and not received; at a limited rate also those that never will be,
  /// for as long as they take.
  std::size_t under_way() const { return arrivals_.size(); }

  const LineCounters& counters() const { return counters_; }

 private:
  /// Each has random numbers of its own.
  enum class Fault : std::uint8_t { bit_error, loss, duplicate, delay, text };

  struct Arrival {
    Instant at{};
    std::optional<std::uint8_t> byte{};  // nothing: the time of a byte that does not arrive
  };

  void settings_changed();
  /// When the first `bits` bits of the run have been sent, rounded up.
  Instant time_of(std::uint64_t bits) const;
  /// The line is at the beginning of another byte, which starts now or behind the last one.
  void begin_byte(Instant now);
  void put(std::uint8_t byte, Instant now);
  void put_with_faults(std::uint8_t byte, Instant now);
  /// The levels of a byte or, if it is lost, of an idle line.
  void put_levels(std::uint8_t byte, std::uint8_t flips, bool is_carried, Duration delay);
  void hear(bool level, Duration delay);
  void hear_idle(Instant until);
  void arrive(std::optional<std::uint8_t> byte, Instant at);
  bool is_text_due(Instant now) const;
  /// The next one; those that are due before are left out.
  void plan_text(Instant after);
  /// Text lines that are due.
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
