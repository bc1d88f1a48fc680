/// Arguments of Python as values of the client.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <sbgc/units.hpp>

#include "binding.hpp"

namespace sbgc::python {

using Seconds = double;

inline std::chrono::milliseconds milliseconds_of(Seconds seconds, const char* what) {
  if (!(seconds >= 0 && seconds <= 1e6)) {
    throw py::value_error(std::string(what) + ": 0 to 1000000 seconds are possible");
  }
  return std::chrono::milliseconds(std::llround(seconds * 1000));
}

inline std::optional<std::chrono::milliseconds> timeout_of(std::optional<Seconds> seconds) {
  if (!seconds) return std::nullopt;
  return milliseconds_of(*seconds, "timeout");
}

/// Raises if the integer does not fit into a T.
template <class T>
T integer_of(std::int64_t value, const char* what) {
  constexpr T highest = std::numeric_limits<T>::max();
  if (value < 0 || static_cast<std::uint64_t>(value) > highest) {
    throw py::value_error(std::string(what) + ": 0 to " + std::to_string(highest) +
                          " are possible, not " + std::to_string(value));
  }
  return static_cast<T>(value);
}

/// Raises if the quantity cannot hold the value.
template <class Q>
Q quantity_of(double value, const char* field) {
  const Conversion<Q> result = Q::from_real(value);
  if (!result) {
    const Q lowest(std::numeric_limits<typename Q::raw_type>::lowest());
    const Q highest(std::numeric_limits<typename Q::raw_type>::max());
    const std::string problem = std::string(field) + ": " + std::to_string(value) +
                                " does not fit: " + std::to_string(lowest.real()) + " to " +
                                std::to_string(highest.real()) + ' ' + Q::unit;
    raise("FieldError", problem, field);
  }
  return *result;
}

}  // namespace sbgc::python
