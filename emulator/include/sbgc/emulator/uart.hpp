/// The reception of a UART on a line whose sender may have different settings.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include <sbgc/line.hpp>
#include <sbgc/types.hpp>

namespace sbgc::emulator {

/// The receiver of a UART. It gets the levels on the line, one per bit of the sender, and samples
/// them at its own rate: 16 ticks per bit, each bit at its center. It drops bytes without a stop
/// bit or with a wrong parity.
class UartReceiver {
 public:
  /// Precondition: neither rate is 0.
  constexpr UartReceiver(const LineSettings& sender, const LineSettings& receiver) noexcept
      : bit_(std::uint64_t{16} * receiver.baud_rate),
        tick_(sender.baud_rate),
        has_parity_(receiver.parity == Parity::even) {}

  /// Sets the level of the line for one bit of the sender. Returns the byte received during it, if
  /// any; start and stop bits guarantee that there is at most one.
  constexpr Optional<std::uint8_t> hear(bool level) noexcept {
    Optional<std::uint8_t> result;
    while (due_ < bit_) {
      const bool waits_for_level =
          (step_ == Step::search && level) || (step_ == Step::wait && !level);
      if (waits_for_level) {  // nothing happens during the rest of this bit
        due_ += (bit_ - due_ + tick_ - 1) / tick_ * tick_;
      } else if (const auto byte = sample(level)) {
        result = byte;
      }
    }
    due_ -= bit_;
    return result;
  }

  /// True if no byte has started.
  constexpr bool is_idle() const noexcept { return step_ == Step::search; }

 private:
  enum class Step : std::uint8_t { search, start, data, parity, stop, wait };

  constexpr Optional<std::uint8_t> sample(bool level) noexcept {
    switch (step_) {
      case Step::search:  // low level: it must still be low half a bit later
        go_on(Step::start, 8);
        break;
      case Step::start:
        data_ = 0;
        bits_ = 0;
        is_good_ = true;
        level ? go_on(Step::search, 1) : go_on(Step::data, 16);
        break;
      case Step::data:
        data_ |= (level ? 1U : 0U) << bits_;
        ++bits_;
        go_on(bits_ < 8 ? Step::data : has_parity_ ? Step::parity : Step::stop, 16);
        break;
      case Step::parity:
        is_good_ = level == (std::popcount(data_) % 2 != 0);
        go_on(Step::stop, 16);
        break;
      case Step::stop:
        go_on(level ? Step::search : Step::wait, 1);
        if (level && is_good_) return static_cast<std::uint8_t>(data_);
        break;
      case Step::wait: go_on(Step::search, 1); break;
    }
    return {};
  }

  constexpr void go_on(Step step, std::uint64_t ticks) noexcept {
    step_ = step;
    due_ += ticks * tick_;
  }

  // The unit of time makes both a sender bit and a tick whole numbers.
  std::uint64_t bit_;
  std::uint64_t tick_;
  std::uint64_t due_ = 0;  // the next sample, relative to the beginning of the next bit
  Step step_ = Step::search;
  unsigned data_ = 0;
  unsigned bits_ = 0;
  bool has_parity_;
  bool is_good_ = true;
};

/// Calls `level(bool)` for each bit that a UART sends for one byte: a start bit (0), 8 data bits,
/// the optional `parity` bit, and a stop bit (1).
template <class Level>
constexpr void send_levels(std::uint8_t byte, Optional<bool> parity, Level level) {
  level(false);
  for (unsigned bit = 0; bit < 8; ++bit) level(((byte >> bit) & 1U) != 0);
  if (parity) level(*parity);
  level(true);
}

/// Returns the parity bit of a byte, if any.
constexpr Optional<bool> parity_bit(std::uint8_t byte, Parity parity) noexcept {
  if (parity == Parity::none) return {};
  return std::popcount(byte) % 2 != 0;
}

/// Returns the bytes that a UART with the settings `receiver` receives if another one sends `bytes`
/// back to back on an idle line with the settings `sender`. Bytes without a stop bit or with a
/// wrong parity are dropped.
std::vector<std::uint8_t> received_as(std::span<const std::uint8_t> bytes,
                                      const LineSettings& sender, const LineSettings& receiver);

}  // namespace sbgc::emulator
