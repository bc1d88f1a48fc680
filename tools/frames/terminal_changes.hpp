/// The changes that the driver of a serial port makes to frames unless the port is in raw mode: it
/// removes some bytes and turns 0x0d into 0x0a.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <sbgc/message.hpp>

namespace sbgc::tools {

/// A header before the driver changed it.
struct ChangedHeader {
  std::uint8_t id{};
  std::uint8_t size{};
  std::string change{};  ///< such as "its size, 0x12, is missing: the port is not in raw mode"
};

/// Returns the header that the driver may have changed to the invalid one after the start byte
/// `bytes[0]`, if it fits a command.
std::optional<ChangedHeader> changed_header(std::span<const std::uint8_t> bytes,
                                            std::optional<Direction> direction);

/// Return a remark, which continues a sentence, if the driver may have changed the body or the
/// trailer of a frame with a valid header; otherwise "". Framings that have only sums tell.
std::string remark_on_replaced(std::span<const std::uint8_t> frame);
/// `rest` is the frame without one byte.
std::string remark_on_removed(std::span<const std::uint8_t> rest);

}  // namespace sbgc::tools
