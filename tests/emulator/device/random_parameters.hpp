/// Parameters with random values, for tests.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/meta/all.hpp>

#include "device/parameters/parameters.hpp"

namespace sbgc::test {

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
