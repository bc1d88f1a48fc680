/// operator<< for every type that <sbgc/text.hpp> prints: std::cout << angles. Includes the tables
/// of all messages.
#pragma once

#include <ostream>

#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>

namespace sbgc {

/// Writes the text of a value.
template <class T>
requires is_printable<T> std::ostream& operator<<(std::ostream& stream, const T& value) {
  return stream << to_string(value);
}

// For argument-dependent lookup.
namespace msg {
using sbgc::operator<<;  // NOLINT(misc-unused-using-decls)
}  // namespace msg
namespace io {
using sbgc::operator<<;  // NOLINT(misc-unused-using-decls)
}  // namespace io

}  // namespace sbgc
