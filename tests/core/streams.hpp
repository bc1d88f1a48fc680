// Byte streams that are difficult to parse, and helpers to make them.
#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <random>
#include <span>

#include "reference_parser.hpp"

namespace sbgc::test {

/// Makes a frame without the library.
inline Bytes make_frame(std::uint8_t id, const Bytes& body) {
  Bytes frame{0x3E, id, static_cast<std::uint8_t>(body.size()),
              static_cast<std::uint8_t>(id + body.size())};
  unsigned sum = 0;
  for (const std::uint8_t byte : body) {
    frame.push_back(byte);
    sum += byte;
  }
  frame.push_back(static_cast<std::uint8_t>(sum));
  return frame;
}

/// The same in the second framing.
inline Bytes make_v2_frame(std::uint8_t id, const Bytes& body) {
  Bytes frame{id, static_cast<std::uint8_t>(body.size()),
              static_cast<std::uint8_t>(id + body.size())};
  frame.insert(frame.end(), body.begin(), body.end());
  const unsigned crc = reference_crc(frame);
  frame.insert(frame.begin(), std::uint8_t{0x24});
  frame.push_back(static_cast<std::uint8_t>(crc));
  frame.push_back(static_cast<std::uint8_t>(crc >> 8));
  return frame;
}

inline Bytes concat(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

class Random {
 public:
  explicit Random(std::uint32_t seed, Accepts framings = Accepts::v1)
      : engine_(seed), framings_(framings) {}

  /// Returns a number below `limit`.
  std::size_t below(std::size_t limit) { return engine_() % limit; }
  std::uint8_t byte() { return static_cast<std::uint8_t>(engine_()); }

  /// Returns noise in which one byte in four is a start byte.
  Bytes noise(std::size_t size) {
    Bytes bytes(size);
    for (std::uint8_t& b : bytes) b = below(4) == 0 ? start() : byte();
    return bytes;
  }

  /// Returns a start byte of one of the framings.
  std::uint8_t start() { return is_v2() ? 0x24 : 0x3E; }

  Bytes frame(std::uint8_t id, const Bytes& body) {
    return is_v2() ? make_v2_frame(id, body) : make_frame(id, body);
  }

  /// Returns a valid frame. Its body is noise, sometimes with a complete frame inside.
  Bytes frame() {
    const auto id = static_cast<std::uint8_t>(1 + below(255));
    const std::size_t size = below(3) == 0 ? below(256) : below(20);
    Bytes body = noise(size);
    if (below(4) == 0 && size > 40) {
      const Bytes inner = frame(7, noise(below(30)));
      std::copy(inner.begin(), inner.end(), body.begin());
    }
    return frame(id, body);
  }

  /// Returns a valid header without the body that it announces.
  Bytes false_header() {
    const auto id = static_cast<std::uint8_t>(1 + below(255));
    const auto size = static_cast<std::uint8_t>(255 - below(40));
    return {start(), id, size, static_cast<std::uint8_t>(id + size)};
  }

  /// Returns frames, complete and damaged, with noise, false headers and runs of one byte between
  /// them.
  Bytes stream(std::size_t pieces) {
    Bytes all;
    for (std::size_t i = 0; i < pieces; ++i) {
      Bytes piece;
      switch (below(8)) {
        case 0: piece = noise(below(50)); break;
        case 1: piece = false_header(); break;
        case 2: piece.assign(below(12), start()); break;
        case 3: piece = concat({{start()}, Bytes(below(12))}); break;
        default: piece = frame();
      }
      if (below(4) == 0 && !piece.empty()) damage(piece);
      all.insert(all.end(), piece.begin(), piece.end());
    }
    return all;
  }

  /// Changes, removes, inserts or repeats one byte.
  void damage(Bytes& bytes) {
    const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size()));
    switch (below(4)) {
      case 0: *place = static_cast<std::uint8_t>(*place ^ (1 + below(255))); break;
      case 1: bytes.erase(place); break;
      case 2: bytes.insert(place, byte()); break;
      default: bytes.insert(place, std::uint8_t{*place}); break;
    }
  }

 private:
  bool is_v2() { return framings_ == Accepts::v2 || (framings_ == Accepts::both && below(2) == 0); }

  std::mt19937 engine_;
  Accepts framings_;
};

}  // namespace sbgc::test
