/// Conversion of Python arguments to values of the client. Errors contain the name of the argument,
/// its value and the limit.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <sbgc/units.hpp>
#include <sbgc/value_text.hpp>

#include "binding.hpp"

namespace sbgc::python {

// These raise a TypeError or a ValueError: "pitch: a number is needed, not 'up'".

double number_of(py::handle value, const char* name);
/// Returns as many digits as needed to distinguish the number from its neighbors.
std::string digits_of(double number);
double number_in(double value, const char* name, double lowest, double highest);
std::int64_t integer_of(py::handle value, const char* name, std::int64_t lowest,
                        std::int64_t highest);
std::string string_of(py::handle value, const char* name);
/// Returns the text of a file name, which may be a pathlib.Path.
std::string path_of(py::handle value, const char* name);
bool flag_of(py::handle value, const char* name);
std::vector<std::string> texts_of(py::handle value, const char* name);
std::vector<std::uint8_t> memory_of(py::handle value, const char* name);

/// The name of an argument, as a template argument.
template <std::size_t size>
struct Name {
  // NOLINTNEXTLINE(google-explicit-constructor): a literal is one
  constexpr Name(const char (&text)[size]) { std::copy_n(text, size, characters); }
  char characters[size]{};
};

/// A parameter of a function that Python calls. T has a function of(value, name).
template <class T, Name name>
struct Argument {
  typename T::Value value{};

  // NOLINTNEXTLINE(google-explicit-constructor): it is the value
  operator const typename T::Value &() const { return value; }
  const auto& operator*() const { return value; }
};

struct NumberArgument {
  using Value = double;
  static Value of(py::handle value, const char* name) { return number_of(value, name); }
};
struct SecondsArgument {
  using Value = std::chrono::milliseconds;
  static Value of(py::handle value, const char* name) {
    const double seconds = number_in(number_of(value, name), name, 0, 1e6);
    return std::chrono::milliseconds(std::llround(seconds * 1000));
  }
};
template <class T>
struct IntegerArgument {
  using Value = T;
  static Value of(py::handle value, const char* name) {
    using Limits = std::numeric_limits<T>;
    constexpr auto highest = static_cast<std::uint64_t>(Limits::max());
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
    return static_cast<T>(
        integer_of(value, name, Limits::min(), static_cast<std::int64_t>(std::min(highest, most))));
  }
};
struct TextArgument {
  using Value = std::string;
  static Value of(py::handle value, const char* name) { return string_of(value, name); }
};
struct PathArgument {
  using Value = std::string;
  static Value of(py::handle value, const char* name) { return path_of(value, name); }
};
struct TextsArgument {
  using Value = std::vector<std::string>;
  static Value of(py::handle value, const char* name) { return texts_of(value, name); }
};
struct FlagArgument {
  using Value = bool;
  static Value of(py::handle value, const char* name) { return flag_of(value, name); }
};
struct MemoryArgument {
  using Value = std::vector<std::uint8_t>;
  static Value of(py::handle value, const char* name) { return memory_of(value, name); }
};
/// Accepts None, too.
template <class T>
struct OptionalArgument {
  using Value = std::optional<typename T::Value>;
  static Value of(py::handle value, const char* name) {
    if (value.is_none()) return std::nullopt;
    return T::of(value, name);
  }
};

template <Name name>
using Float = Argument<NumberArgument, name>;
template <Name name>
using OptionalFloat = Argument<OptionalArgument<NumberArgument>, name>;
template <Name name>
using Seconds = Argument<SecondsArgument, name>;
template <Name name>
using OptionalSeconds = Argument<OptionalArgument<SecondsArgument>, name>;
template <class T, Name name>
using Integer = Argument<IntegerArgument<T>, name>;
template <class T, Name name>
using OptionalInteger = Argument<OptionalArgument<IntegerArgument<T>>, name>;
template <Name name>
using Text = Argument<TextArgument, name>;
template <Name name>
using Path = Argument<PathArgument, name>;
template <Name name>
using OptionalPath = Argument<OptionalArgument<PathArgument>, name>;
template <Name name>
using Texts = Argument<TextsArgument, name>;
template <Name name>
using Flag = Argument<FlagArgument, name>;
template <Name name>
using Memory = Argument<MemoryArgument, name>;

/// Raises with the problem that parse_quantity() finds.
template <class Q>
[[noreturn]] void raise_unfit(double value, const char* field) {
  const std::string problem = parse_quantity<Q>(digits_of(value) + ' ' + Q::unit).problem;
  raise("FieldError", std::string(field) + ": " + problem, field);
}

/// Raises if the quantity cannot hold the value.
template <class Q>
Q quantity_of(double value, const char* field) {
  const Conversion<Q> result = Q::from_real(value);
  if (!result) raise_unfit<Q>(value, field);
  return *result;
}

/// Raises if the speed rounds to 0, which would mean another speed.
msg::ControlSpeed speed_of(double value, const char* field);

}  // namespace sbgc::python

namespace pybind11::detail {

template <class T, sbgc::python::Name called>
struct type_caster<sbgc::python::Argument<T, called>> {
  using Type = sbgc::python::Argument<T, called>;
  PYBIND11_TYPE_CASTER(Type, const_name("object"));

  /// Raises instead of returning false, for which pybind11 would list the C++ types.
  bool load(handle given, bool) {
    value.value = T::of(given, called.characters);
    return true;
  }
};

}  // namespace pybind11::detail
