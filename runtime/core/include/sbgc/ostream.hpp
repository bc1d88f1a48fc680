/// Streams print everything that <sbgc/text.hpp> has a text for: std::cout << angles. Every message
/// is known.
#pragma once

#include <ostream>

#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>

namespace sbgc {

template <class T>
requires is_printable<T> std::ostream& operator<<(std::ostream& stream, const T& value) {
  return stream << to_string(value);
}

// For calls that find it by the namespace of the value.
namespace msg {
using sbgc::operator<<;
}  // namespace msg
namespace io {
using sbgc::operator<<;
}  // namespace io

}  // namespace sbgc
