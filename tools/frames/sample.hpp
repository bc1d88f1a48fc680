/// The values of one message, as tables show them.
#pragma once

#include <functional>
#include <string>

#include <sbgc/text/leaves.hpp>

namespace sbgc::tools {

/// A value that samples have.
struct StreamField {
  std::string path{};  ///< for example "angle.roll"
  std::string unit{};  ///< "" if it has none
};

/// Calls its argument with each value of a sample.
using Sample = std::function<void(const std::function<void(const Leaf&)>&)>;

}  // namespace sbgc::tools
