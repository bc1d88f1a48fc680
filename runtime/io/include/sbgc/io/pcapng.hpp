/// Captures for Wireshark: blocks of pcapng, a packet format with times and directions.
///
/// The link type is LINKTYPE_USER13, for which the dissector of the project registers. A packet has
/// the bytes of one read or write, and its direction in its flags. A packet without bytes and
/// direction begins a session, in which no earlier data continues.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/io/capture.hpp>
#include <sbgc/version.hpp>
#include <sbgc/wire.hpp>

namespace sbgc::io::pcapng {

/// A part of a file.
using Bytes = std::vector<std::uint8_t>;
/// The time of a packet.
using Time = std::chrono::sys_time<std::chrono::microseconds>;

/// USER13, which is reserved for private use.
inline constexpr std::uint16_t link_type = 160;
/// A file begins with the type of its first block, which is the same in either byte order.
inline constexpr std::array<std::uint8_t, 4> magic{0x0A, 0x0D, 0x0D, 0x0A};

namespace detail {

enum class Block : std::uint32_t { section = 0x0A0D0D0A, interface = 1, packet = 6 };
enum class Option : std::uint16_t { end = 0, comment = 1, name_or_flags = 2, application = 4 };

template <class T>
void append(Bytes& to, T value) {
  to.resize(to.size() + sizeof value);
  wire::store(to.data() + to.size() - sizeof value, value);
}

/// Appends bytes, and zeros up to a multiple of 4.
inline void append_padded(Bytes& to, std::span<const std::uint8_t> bytes) {
  to.insert(to.end(), bytes.begin(), bytes.end());
  to.resize(to.size() + (4 - bytes.size() % 4) % 4);
}

inline void append_option(Bytes& to, Option option, std::span<const std::uint8_t> value) {
  constexpr std::size_t longest = 0xFFFF;
  value = value.first(std::min(value.size(), longest));
  append(to, static_cast<std::uint16_t>(option));
  append(to, static_cast<std::uint16_t>(value.size()));
  append_padded(to, value);
}

inline void append_option(Bytes& to, Option option, std::string_view text) {
  append_option(to, option, Bytes(text.begin(), text.end()));
}

/// Appends a block with the content that `fill` appends.
template <class Fill>
void append_block(Bytes& to, Block type, const Fill& fill) {
  const std::size_t begin = to.size();
  append(to, static_cast<std::uint32_t>(type));
  append(to, std::uint32_t{0});
  fill();
  append(to, std::uint32_t{0});  // the end of the options
  const auto size = static_cast<std::uint32_t>(to.size() + sizeof(std::uint32_t) - begin);
  append(to, size);
  wire::store(to.data() + begin + sizeof size, size);
}

}  // namespace detail

/// Appends the beginning of a file: the section, and the line as its interface.
inline void append_section(Bytes& to) {
  using detail::append;
  using detail::Option;
  detail::append_block(to, detail::Block::section, [&] {
    append(to, std::uint32_t{0x1A2B3C4D});
    append(to, std::uint16_t{1});  // version 1.0
    append(to, std::uint16_t{0});
    append(to, std::uint32_t{0xFFFFFFFF});  // of unknown size
    append(to, std::uint32_t{0xFFFFFFFF});
    detail::append_option(to, Option::application, "sbgc " SBGC_VERSION_TEXT);
  });
  detail::append_block(to, detail::Block::interface, [&] {
    append(to, std::uint32_t{link_type});
    append(to, std::uint32_t{0});  // packets of any size
    detail::append_option(to, Option::name_or_flags, "sbgc");
  });
}

/// Appends a packet. It has a direction only if it holds bytes from or to the board.
inline void append_packet(Bytes& to, Time time, CaptureKind kind,
                          std::span<const std::uint8_t> bytes,
                          std::span<const std::string> comments = {}) {
  using detail::append;
  using detail::Option;
  const auto count = static_cast<std::uint64_t>(time.time_since_epoch().count());
  const auto size = static_cast<std::uint32_t>(bytes.size());
  detail::append_block(to, detail::Block::packet, [&] {
    append(to, std::uint32_t{0});  // the interface
    append(to, static_cast<std::uint32_t>(count >> 32));
    append(to, static_cast<std::uint32_t>(count));
    append(to, size);
    append(to, size);
    detail::append_padded(to, bytes);
    for (const std::string& comment : comments) {
      detail::append_option(to, Option::comment, comment);
    }
    if (kind == CaptureKind::from_board || kind == CaptureKind::to_board) {
      const std::uint8_t flags = kind == CaptureKind::from_board ? 1 : 2;  // inbound, outbound
      detail::append_option(to, Option::name_or_flags, std::array<std::uint8_t, 4>{flags});
    }
  });
}

}  // namespace sbgc::io::pcapng
