/// Random input of a board: requests with random values, invalid bytes, and parameters.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/dispatch.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/meta/all.hpp>

#include "device/parameters/parameters.hpp"

namespace sbgc::test {

using Bytes = std::vector<std::uint8_t>;

inline Bytes frame_of(std::uint8_t id, std::span<const std::uint8_t> body) {
  std::array<std::uint8_t, max_frame_size> frame{};
  const WriteResult written = write_frame(id, body, frame);
  return {frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(written.size)};
}

/// Each request has a form of the model; one in eight has a wrong size, one in eight is not a
/// frame.
class RandomRequests {
 public:
  explicit RandomRequests(std::uint32_t seed) : random_(seed) {
    AllMessages::for_each([this]<class M>(Type<M>) {
      if constexpr (M::direction != Direction::from_board) {
        forms_.push_back({static_cast<std::uint8_t>(M::command), M::min_size, M::max_size});
      }
    });
  }

  std::uint32_t up_to(std::uint32_t most) {
    return std::uniform_int_distribution<std::uint32_t>(0, most)(random_);
  }

  Bytes next() {
    const Form& form = forms_[up_to(static_cast<std::uint32_t>(forms_.size()) - 1)];
    const std::uint32_t kind = up_to(7);
    auto size = static_cast<std::uint32_t>(form.min_size);
    if (form.max_size > form.min_size && up_to(1) == 0) {
      size += up_to(static_cast<std::uint32_t>(form.max_size - form.min_size));
    }
    if (kind == 0) size = up_to(max_body_size);
    Bytes body(size);
    // Small numbers are meaningful more often.
    const std::uint32_t most = up_to(2) == 0 ? 255 : 4;
    for (auto& byte : body) byte = static_cast<std::uint8_t>(up_to(most));
    if (kind == 1) return body;
    return frame_of(form.id, body);
  }

 private:
  struct Form {
    std::uint8_t id{};
    std::size_t min_size{}, max_size{};
  };

  std::mt19937 random_;
  std::vector<Form> forms_{};
};

using emulator::Parameters;
using ByteVector = std::vector<std::uint8_t>;

template <class M>
ByteVector bytes_of(const M& message) {
  ByteVector bytes(max_body_size);
  bytes.resize(encode(message, bytes).size);
  return bytes;
}

template <class M>
void set_copy(M& message, std::uint8_t copy) {
  if constexpr (ParametersOf<M>::copies > 1) ParametersOf<M>::copy(message) = copy;
}

/// Returns a message decoded from random bytes with a tail, including reserved bytes and undefined
/// values.
template <class M>
M random_message(std::mt19937& random, std::uint8_t copy) {
  ByteVector body(M::min_size + random() % (max_body_size - M::min_size + 1));
  for (auto& byte : body) byte = static_cast<std::uint8_t>(random());
  M message{};
  EXPECT_TRUE(decode(std::span(body), message));
  EXPECT_EQ(bytes_of(message), body);
  set_copy(message, copy);
  return message;
}

/// Returns the message with the general parameters of another.
template <class M>
M with_general_of(const M& from, M message) {
  if constexpr (ParametersOf<M>::copies > 1) ParametersOf<M>::share(from, message);
  return message;
}

/// Calls `use` with random bodies of all messages with parameters, always in the same order.
template <class Use>
void for_each_random(unsigned seed, Use&& use) {
  std::mt19937 random(seed);
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    const M first = random_message<M>(random, 0);
    use(std::uint8_t{0}, first);
    for (std::uint8_t copy = 1; copy < ParametersOf<M>::copies; ++copy) {
      use(copy, with_general_of(first, random_message<M>(random, copy)));
    }
  });
}

inline void write_random(Parameters& parameters, unsigned seed) {
  for_each_random(seed, [&](std::uint8_t copy, const auto& message) {
    EXPECT_TRUE(parameters.write(copy, message));
  });
}

inline void expect_random(const Parameters& parameters, unsigned seed) {
  for_each_random(seed, [&]<class M>(std::uint8_t copy, const M& message) {
    EXPECT_EQ(bytes_of(parameters.read<M>(copy)), bytes_of(message))
        << Meta<M>::info.name << ' ' << int{copy};
  });
}

}  // namespace sbgc::test
