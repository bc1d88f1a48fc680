/// Helpers shared by the tests of the codec.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/dispatch.hpp>
#include <sbgc/message.hpp>

namespace sbgc::test {

using ByteVector = std::vector<std::uint8_t>;

/// Converts hex digits to bytes, ignoring spaces and newlines.
inline ByteVector from_hex(std::string_view text) {
  std::string digits;
  for (const char c : text) {
    if (c != ' ' && c != '\n') digits += c;
  }
  ByteVector bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(digits.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

/// A copy in an allocation of exactly its size, so that a sanitizer detects a read past the end.
class ExactCopy {
 public:
  explicit ExactCopy(std::span<const std::uint8_t> bytes)
      : bytes_(std::make_unique<std::uint8_t[]>(bytes.size())), size_(bytes.size()) {
    if (size_ != 0) std::memcpy(bytes_.get(), bytes.data(), size_);
  }
  std::span<const std::uint8_t> get() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<std::uint8_t[]> bytes_;
  std::size_t size_;
};

/// Returns the body of a message, or an empty vector if it does not encode.
template <class M>
ByteVector body_of(const M& message) {
  ByteVector body(max_body_size);
  const WriteResult written = encode(message, body);
  body.resize(written.size);
  return body;
}

/// Returns the frame of a message, or an empty vector if it does not encode.
template <class M>
ByteVector frame_of(const M& message) {
  ByteVector frame(max_frame_size);
  const WriteResult written = encode_frame(message, frame);
  frame.resize(written.size);
  return frame;
}

/// Random bodies: of any bytes, of small ones (so that counters fit), and of extremes.
class RandomBodies {
 public:
  explicit RandomBodies(std::uint32_t seed) : random_(seed) {}

  ByteVector next(std::size_t size) {
    ByteVector body(size);
    const auto kind = random_() % 4;
    std::uint_fast32_t values = 0;  // one number makes four bytes
    std::uint8_t* const bytes = body.data();
    for (std::size_t i = 0; i < size; ++i) {
      values = i % 4 == 0 ? random_() : values >> 8;
      const auto byte = static_cast<std::uint8_t>(values);
      bytes[i] = byte;
      if (kind == 2) bytes[i] = byte % 8;
      if (kind == 3) bytes[i] = byte % 2 == 0 ? 0x00 : 0xFF;
    }
    // Most bodies start with an id or a counter, and random bytes would miss many of their values.
    if (size != 0 && random_() % 2 == 0) body[0] = static_cast<std::uint8_t>(random_() % 64);
    return body;
  }

 private:
  std::mt19937 random_;
};

}  // namespace sbgc::test
