/// Which values of enums and flag sets a board knows.
#pragma once

#include <cstdint>

#include <sbgc/availability.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::emulator {

/// Whether boards with these versions know a value.
template <class E>
constexpr bool knows(const Availability& versions, E value) {
  for (const ValueInfo& info : EnumMeta<E>::values) {
    if (info.value == static_cast<std::int64_t>(value)) return is_available(info.since, versions);
  }
  return false;
}

}  // namespace sbgc::emulator
