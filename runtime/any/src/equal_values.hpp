/// Compares messages by their tables.
#pragma once

#include <sbgc/internal/table.hpp>

namespace sbgc::detail {

/// As operator== of the messages, which compares real numbers as such.
bool are_equal(const StructTable& table, const void* a, const void* b) noexcept;

}  // namespace sbgc::detail
