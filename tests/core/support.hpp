/// What the tests of the codec share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/dispatch.hpp>
#include <sbgc/message.hpp>

namespace sbgc::test {

using ByteVector = std::vector<std::uint8_t>;

/// The bytes of hex digits; white space is ignored.
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

/// A copy with nothing readable behind it, so that a sanitizer notices the first byte too many.
class ExactCopy {
 public:
  explicit ExactCopy(std::span<const std::uint8_t> bytes)
      : bytes_(std::make_unique<std::uint8_t[]>(bytes.size())), size_(bytes.size()) {
    for (std::size_t i = 0; i < size_; ++i) bytes_[i] = bytes[i];
  }
  std::span<const std::uint8_t> get() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<std::uint8_t[]> bytes_;
  std::size_t size_;
};

/// decode() with the context that the message needs, if it needs one.
template <class M>
Status decode_in(std::span<const std::uint8_t> body, M& message, const Contexts& contexts) {
  if constexpr (requires { contexts.of(message); }) {
    return decode(body, message, contexts.of(message));
  } else {
    return decode(body, message);
  }
}

/// The body of a message; empty if it does not encode.
template <class M>
ByteVector body_of(const M& message) {
  ByteVector body(max_body_size);
  const WriteResult written = encode(message, body);
  body.resize(written.size);
  return body;
}

/// The frame of a message; empty if it does not encode.
template <class M>
ByteVector frame_of(const M& message) {
  ByteVector frame(max_frame_size);
  const WriteResult written = encode_frame(message, frame);
  frame.resize(written.size);
  return frame;
}

/// Random bodies: some of any bytes, some of small ones (so that counters fit), some of extremes.
class RandomBodies {
 public:
  explicit RandomBodies(std::uint32_t seed) : random_(seed) {}

  ByteVector next(std::size_t size) {
    ByteVector body(size);
    const auto kind = random_() % 4;
    for (std::uint8_t& byte : body) {
      const auto value = random_();
      if (kind == 0 || kind == 1) byte = static_cast<std::uint8_t>(value >> 8);
      if (kind == 2) byte = static_cast<std::uint8_t>((value >> 8) % 8);
      if (kind == 3) byte = (value >> 8) % 2 == 0 ? 0x00 : 0xFF;
    }
    // Ids and counters mostly stand first; without this many would never be met.
    if (size != 0 && random_() % 2 == 0) body[0] = static_cast<std::uint8_t>(random_() % 64);
    return body;
  }

 private:
  std::mt19937 random_;
};

}  // namespace sbgc::test
