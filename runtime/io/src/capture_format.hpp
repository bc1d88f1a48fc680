/// Shared code of the reader and the writer of captures: see sbgc/io/capture.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/io/capture.hpp>

namespace sbgc::io::capture_format {

inline constexpr std::array<std::uint8_t, capture_magic_size> magic{0x89, 'S',  'B',  'G',
                                                                    'C',  0x0D, 0x0A, 0x1A};
inline constexpr std::uint16_t version = 1;
inline constexpr std::size_t header_size = 24;
inline constexpr std::size_t start_offset = 12;
inline constexpr std::uint8_t record_mark = 0xA5;
inline constexpr std::size_t record_head_size = 12;
inline constexpr std::size_t time_offset = 4;
inline constexpr std::size_t checksum_size = 4;
inline constexpr std::size_t max_bytes = 65535;

}  // namespace sbgc::io::capture_format
