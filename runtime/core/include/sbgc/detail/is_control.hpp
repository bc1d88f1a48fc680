/// Control characters, which a terminal would obey.
#pragma once

namespace sbgc::detail {

/// True for an ASCII control character. Plain char is signed on some machines only.
constexpr bool is_control(char c) noexcept {
  const auto code = static_cast<unsigned char>(c);
  return code < 0x20 || code == 0x7F;
}

}  // namespace sbgc::detail
