/// The metadata of all messages, in the order of the specification's families.
#pragma once

#include <array>

#include <sbgc/dispatch.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc {

namespace detail {

template <class... Ms>
constexpr std::array<const MessageInfo*, sizeof...(Ms)> infos_of(TypeList<Ms...>) {
  return {&Meta<Ms>::info...};
}

}  // namespace detail

/// The metadata of every message. <sbgc/any.hpp> also makes and decodes messages.
inline constexpr auto message_infos = detail::infos_of(AllMessages{});

/// Returns the same as is_supported() of <sbgc/availability.hpp>, for a message that is known at
/// run time.
constexpr bool is_supported(const MessageInfo& info, const Availability& versions) noexcept {
  const bool has_end = info.until.firmware != 0 || info.until.board != 0;
  return is_available(info.since, versions) && !(has_end && is_available(info.until, versions));
}

}  // namespace sbgc
