#include <sbgc/emulator/uart.hpp>

namespace sbgc::emulator {

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
