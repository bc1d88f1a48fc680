/// Times of tasks as numbers.
#pragma once

#include <sbgc/time.hpp>

namespace sbgc::doctor {

constexpr double in_seconds(Duration duration) { return 1e-6 * static_cast<double>(duration.us); }

}  // namespace sbgc::doctor
