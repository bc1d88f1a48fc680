/// The values of enums and flag sets that a board supports.
#pragma once

#include <cstdint>

#include <sbgc/availability.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::emulator {

/// True if boards with these versions support a value.
template <class E>
constexpr bool knows(const Availability& versions, E value) {
  for (const ValueInfo& info : EnumMeta<E>::values) {
    if (info.value == static_cast<std::int64_t>(value)) return is_available(info.since, versions);
  }
  return false;
}

}  // namespace sbgc::emulator
