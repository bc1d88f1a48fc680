/// The steps of the path of a field, as text: "params[3].param_id".
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include <sbgc/internal/parse_number.hpp>

namespace sbgc::detail {

/// Parses one step after the other.
class PathSteps {
 public:
  explicit PathSteps(std::string_view path) : rest_(path) {}

  bool is_end() const noexcept { return rest_.empty(); }

  std::string_view take_name() {
    if (rest_.starts_with('.')) rest_.remove_prefix(1);
    const std::string_view name =
        rest_.substr(0, std::min(rest_.find_first_of(".["), rest_.size()));
    rest_.remove_prefix(name.size());
    return name;
  }

  /// Returns the index at the beginning of the rest; a huge one if there is none.
  std::size_t take_index() {
    const std::size_t close = rest_.find(']');
    if (!rest_.starts_with('[') || close == std::string_view::npos) return ~std::size_t{0};
    const auto index = parse_number<std::size_t>(rest_.substr(1, close - 1));
    if (!index) return ~std::size_t{0};
    rest_.remove_prefix(close + 1);
    return *index;
  }

 private:
  std::string_view rest_;
};

}  // namespace sbgc::detail
