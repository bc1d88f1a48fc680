/// std::ranges::find() with a projection, which libc++ 14 does not have.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>

namespace sbgc::detail {

/// Returns the position of the first element whose `member` has this value, or the end.
template <class Range, class Value, class Member>
constexpr auto find_by(Range&& range, const Value& value, Member member) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](const auto& element) { return std::invoke(member, element) == value; });
}

}  // namespace sbgc::detail
