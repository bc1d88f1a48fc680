/// Arguments of Python as values of the client.
#pragma once

#include <chrono>
#include <cmath>
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
