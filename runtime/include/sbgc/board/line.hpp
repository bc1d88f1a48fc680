/// The line between a host and an emulated board, with the faults of real ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sbgc/line.hpp>
#include <sbgc/time.hpp>

namespace sbgc::board {

/// A length of time in which the line carries nothing.
struct Silence {
  Duration from{};  ///< since the line began
  Duration length{};
};

/// Shares are 0..1, of bytes unless said otherwise; both directions.
struct Faults {
  double bit_errors = 0;  ///< of bits
  double lost = 0;
  double duplicated = 0;
  double delayed = 0;  ///< the byte and all behind it come `delay` later
  Duration delay = milliseconds(20);
  /// Text lines between frames of the board, so often; 0: never.
  Duration text_every{};
  std::vector<Silence> silences{};

  bool any() const;
};

struct LineOptions {
  /// The line's own rate and parity: bytes take their time. 0: no limit.
  LineSettings board{};
  /// What else the board's UART hears as its own: it detects even parity by itself.
  bool detects_parity = true;
  Faults faults{};
  std::uint32_t seed = 1;
};

/// One direction or the other of a line: bytes go in at one end and come out at the other, later.
/// Deterministic: the same bytes at the same times meet the same faults, however they are cut.
class Line {
 public:
  enum class Way : std::uint8_t { to_board, to_host };

  Line(const LineOptions& options, Way way, Instant start);

  /// What the host's serial port is set to; none: the same as the board's. Bytes become the garbage
  /// that a UART would make of them while they differ.
  void set_host(std::optional<LineSettings> settings);
  /// The board has another rate from now on.
  void set_board(const LineSettings& settings);

  /// `is_end_of_frame`: text lines may follow.
  void send(std::span<const std::uint8_t> bytes, Instant now, bool is_end_of_frame = false);
  /// The bytes that have arrived up to now, taken away.
  std::vector<std::uint8_t> arrived(Instant now);
  /// When the next byte arrives; Instant::never if none is on its way.
  Instant next() const;
  /// How many more bytes the sender's UART takes now; its buffer is the board's.
  bool is_busy(Instant now) const;
};

}  // namespace sbgc::board
