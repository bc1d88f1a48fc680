
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <string_view>

#include <sbgc/emulator/line.hpp>
#include <sbgc/emulator/uart.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/framing.hpp>

#include "physics/noise.hpp"

namespace sbgc::emulator {

namespace {

constexpr std::uint64_t us_per_second = 1'000'000;

/// Assumption: debug output that firmware might print. One line contains a start byte.
constexpr std::array<std::string_view, 4> text_lines{"I2C errors: 2\r\n", "loop: 812us\r\n",
                                                     "IMU temp > 40C\r\n", "RC lost\r\n"};

/// The settings of the two ends of a line, which determine what the receiver gets.
struct Ends {
  LineSettings sender{};
  LineSettings receiver{};
};

Ends ends(const LineOptions& options, const std::optional<LineSettings>& host, Line::Way way) {
  LineSettings board = options.board;
  LineSettings other = host && host->baud_rate != 0 && board.baud_rate != 0 ? *host : board;
  if (options.detects_parity) board.parity = other.parity;
  return way == Line::Way::to_host ? Ends{board, other} : Ends{other, board};
}

}  // namespace

Line::Line(const LineOptions& options, Way way, Instant beginning, Instant now)
    : options_(options),
      way_(way),
      beginning_(beginning),
      run_(now),
      handed_over_(now),
      last_arrival_(now) {
  set_faults(options.faults, now);
  settings_changed();
}

void Line::set_faults(const Faults& faults, Instant now) {
  options_.faults = faults;
  text_due_.reset();
  if (way_ == Way::to_host && faults.text_every > Duration{}) plan_text(now);
}

void Line::set_host(const std::optional<LineSettings>& settings) {
  if (settings == host_) return;
  host_ = settings;
  settings_changed();
}

void Line::set_board(const LineSettings& settings) {
  if (settings == options_.board) return;
  options_.board = settings;
  settings_changed();
}

void Line::settings_changed() {
  run_ = time_of(run_bits_);  // bytes already sent keep their duration
  run_bits_ = 0;
  const auto [sender, receiver] = ends(options_, host_, way_);
  sender_ = sender;
  uart_.reset();
  if (sender != receiver) uart_.emplace(sender, receiver);
}

Instant Line::time_of(std::uint64_t bits) const {
  if (bits == 0) return run_;
  const std::uint64_t rate = sender_.baud_rate;
  return run_ + Duration{static_cast<std::int64_t>((bits * us_per_second + rate - 1) / rate)};
}

std::size_t Line::room(Instant now) const {
  if (sender_.baud_rate == 0) return std::numeric_limits<std::size_t>::max();
  const std::uint64_t passed_us = static_cast<std::uint64_t>(std::max((now - run_).us, {}));
  if (now >= time_of(run_bits_)) return fifo_size;
  const std::uint64_t left = run_bits_ - passed_us * sender_.baud_rate / us_per_second;
  const std::uint64_t bits = bits_per_byte(sender_.parity);
  const std::uint64_t waiting = (left + bits - 1) / bits;
  return waiting >= fifo_size ? 0 : fifo_size - static_cast<std::size_t>(waiting);
}

Instant Line::ready() const {
  const std::uint64_t half = fifo_size / 2 * bits_per_byte(sender_.parity);
  return time_of(run_bits_ > half ? run_bits_ - half : 0);
}

void Line::begin_byte(Instant now) {
  if (sender_.baud_rate == 0) {
    run_ = later(run_, now);
    run_bits_ = 0;
    return;
  }
  // Times are whole microseconds: bytes sent in the microsecond in which the last byte ends follow
  // it without a pause.
  if (now <= time_of(run_bits_)) return;
  hear_idle(now);
  if (uart_ && !uart_->is_idle()) {  // still sampling: the next byte starts with the next bit
    hear(true, byte_delay_);
  } else {
    run_ = now;
    run_bits_ = 0;
  }
}

void Line::send(std::span<const std::uint8_t> bytes, Instant now) {
  for (const std::uint8_t byte : bytes) {
    put_text(later(now, time_of(run_bits_)));
    handed_over_ = now;
    put_with_faults(byte, now);
    if (way_ == Way::to_host) follow_frame(byte);
  }
}

void Line::put_with_faults(std::uint8_t byte, Instant now) {
  const std::uint64_t number = counters_.bytes;
  put(byte, now);
  if (happens(Fault::duplicate, options_.faults.duplicated, number)) {
    ++counters_.duplicated;
    put(byte, now);
  }
}

void Line::put(std::uint8_t byte, Instant now) {
  begin_byte(now);
  const std::uint64_t number = counters_.bytes++;
  const Faults& faults = options_.faults;
  std::uint8_t flips = 0;
  if (faults.bit_errors > 0) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      const bool is_wrong = happens(Fault::bit_error, faults.bit_errors, number * 8 + bit);
      flips = static_cast<std::uint8_t>(flips | (is_wrong ? 1U << bit : 0U));
    }
  }
  const std::uint64_t bits = sender_.baud_rate == 0 ? 0 : bits_per_byte(sender_.parity);
  bool is_carried = true;
  if (is_silent(time_of(run_bits_), time_of(run_bits_ + bits))) {
    ++counters_.silenced;
    is_carried = false;
  } else if (happens(Fault::loss, faults.lost, number)) {
    ++counters_.lost;
    is_carried = false;
  }
  Duration delay{};
  if (is_carried && happens(Fault::delay, faults.delayed, number)) {
    ++counters_.delayed;
    delay = faults.delay;
  }
  if (is_carried) counters_.bit_errors += static_cast<std::uint64_t>(std::popcount(flips));
  put_levels(byte, flips, is_carried, delay);
}

void Line::put_levels(std::uint8_t byte, std::uint8_t flips, bool is_carried, Duration delay) {
  const auto parity = parity_bit(byte, sender_.parity);
  const auto changed = static_cast<std::uint8_t>(byte ^ flips);
  if (uart_) {
    ++counters_.mismatched;
    byte_delay_ = delay;
    const std::size_t before = arrivals_.size();
    send_levels(changed, parity, [&](bool level) { hear(level || !is_carried, delay); });
    if (arrivals_.size() == before) arrive(std::nullopt, time_of(run_bits_));
    return;
  }
  if (sender_.baud_rate != 0) run_bits_ += bits_per_byte(sender_.parity);
  const bool has_parity_error = is_carried && parity_bit(changed, sender_.parity) != parity;
  if (has_parity_error) ++counters_.parity_errors;
  if (is_carried && !has_parity_error) return arrive(changed, time_of(run_bits_) + delay);
  if (sender_.baud_rate != 0) arrive(std::nullopt, time_of(run_bits_));
}

void Line::hear(bool level, Duration delay) {
  ++run_bits_;
  // The microsecond in which the bit ends must have passed; see receive().
  if (const auto byte = uart_->hear(level)) {
    arrive(*byte, time_of(run_bits_) + microseconds(1) + delay);
  }
}

void Line::hear_idle(Instant until) {
  while (uart_ && !uart_->is_idle() && time_of(run_bits_ + 1) <= until) hear(true, byte_delay_);
}

void Line::arrive(std::optional<std::uint8_t> byte, Instant at) {
  last_arrival_ = later(last_arrival_, at);
  arrivals_.push_back({last_arrival_, byte});
}

bool Line::is_text_due(Instant now) const {
  return text_due_ && frame_bytes_ == 0 && *text_due_ <= now;
}

void Line::plan_text(Instant after) {
  const Duration every = options_.faults.text_every;
  text_due_ = beginning_ + Duration{((after - beginning_).us / every.us + 1) * every.us};
}

void Line::skip_text(Instant now) {
  if (is_text_due(now)) plan_text(now);
}

void Line::put_text(Instant until) {
  while (is_text_due(until)) {
    const Instant at = later(*text_due_, handed_over_);
    const std::uint64_t choice = random_bits(seed(Fault::text), counters_.text_lines++);
    for (const char letter : text_lines[choice % text_lines.size()]) {
      put_with_faults(static_cast<std::uint8_t>(letter), at);
    }
    plan_text(later(at, time_of(run_bits_)));
  }
}

void Line::follow_frame(std::uint8_t byte) {
  if (frame_bytes_ == 0) {
    if (AllFrameFormats::inspect(&byte, 1).verdict == Verdict::no_start) return;
    framing_ = framing_of(&byte);
  }
  ++frame_bytes_;
  if (frame_bytes_ == frame_size_offset + 1) frame_size_ = frame_size(framing_, byte);
  if (frame_bytes_ >= frame_header_size && frame_bytes_ == frame_size_) frame_bytes_ = 0;
}

void Line::receive(Instant now, std::vector<std::uint8_t>& into) {
  put_text(now);
  // A byte sent in this microsecond may still follow without a pause.
  hear_idle(now - microseconds(1));
  while (!arrivals_.empty() && arrivals_.front().at <= now) {
    if (const auto byte = arrivals_.front().byte) into.push_back(*byte);
    arrivals_.pop_front();
  }
}

Instant Line::next() const {
  Instant result = Instant::never;
  if (!arrivals_.empty()) result = arrivals_.front().at;
  if (text_due_ && frame_bytes_ == 0) result = earlier(result, *text_due_);
  if (uart_ && !uart_->is_idle()) {  // the bytes that arrive if the line stays idle
    UartReceiver uart = *uart_;
    std::uint64_t bits = run_bits_;
    while (!uart.is_idle() && time_of(bits) < result) {
      ++bits;
      uart.hear(true);
    }
    result = earlier(result, time_of(bits) + microseconds(1));
  }
  return result;
}

bool Line::is_silent(Instant from, Instant until) const {
  return std::any_of(options_.faults.silences.begin(), options_.faults.silences.end(),
                     [&](const Silence& silence) {
                       const Instant begin = beginning_ + silence.from;
                       return from < begin + silence.length && (from >= begin || until > begin);
                     });
}

bool Line::happens(Fault fault, double share, std::uint64_t number) const {
  return share > 0 && random_share(seed(fault), number) < share;
}

std::uint64_t Line::seed(Fault fault) const {
  return random_bits(options_.seed,
                     static_cast<std::uint64_t>(fault) * 2 + (way_ == Way::to_host ? 1U : 0U));
}

std::vector<std::uint8_t> received_as(std::span<const std::uint8_t> bytes,
                                      const LineSettings& sender, const LineSettings& receiver) {
  if (sender == receiver) return {bytes.begin(), bytes.end()};
  UartReceiver uart(sender, receiver);
  std::vector<std::uint8_t> result;
  const auto hear = [&](bool level) {
    if (const auto byte = uart.hear(level)) result.push_back(*byte);
  };
  for (const std::uint8_t byte : bytes) send_levels(byte, parity_bit(byte, sender.parity), hear);
  while (!uart.is_idle()) hear(true);
  return result;
}

}  // namespace sbgc::emulator
