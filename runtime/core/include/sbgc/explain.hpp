/// Explains why a body does not decode, or why a board does not know a message. Requires a hosted
/// standard library.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <sbgc/codec.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>

namespace sbgc {

namespace detail {

/// The body size that the message needs, and the reason.
struct NeededSize {
  std::size_t size{};        ///< 0 if it is not known
  bool depends_on_flags{};   ///< which announce the members that are present
  const char* without = "";  ///< the only flag without which the body has the right size, or ""
};

/// Tries which size a message has without each of its flags. Not a template, which would be
/// compiled for each message.
struct FlagTrial {
  NeededSize& needed;
  std::size_t body_size{};
  std::size_t (*size)(const void* message){};
  const void* message{};
  std::size_t candidates = 0;

  template <class Member>
  void operator()(const FieldInfo&, Member&& member) {
    (*this)(member);
  }
  template <class Member>
  void operator()(Member& member) {
    if constexpr (requires { typename Member::flag_type; }) {
      using Flag = typename Member::flag_type;
      const Member all = member;
      for (const ValueInfo& value : EnumMeta<Flag>::info.values) {
        const auto flag = static_cast<Flag>(value.value);
        if (!all.has(flag)) continue;
        member.set(flag, false);
        add(size(message), value.name);
        member = all;
      }
    }
  }

  void add(std::size_t rest, const char* without) {
    if (rest != needed.size) needed.depends_on_flags = true;
    if (rest == body_size) needed.without = ++candidates == 1 ? without : "";
  }
};

template <class M, class... Context>
NeededSize needed_size([[maybe_unused]] std::span<const std::uint8_t> body, Context... context) {
  NeededSize needed{.size = fixed_size<M>};
  if constexpr (HasVaryingMembers<M>) {
    // Missing bytes read as zero; there are more of them than any message needs.
    std::array<std::uint8_t, 4 * max_body_size> padded{};
    std::copy(body.begin(), body.end(), padded.begin());
    M message{};
    if constexpr (HasFixedMembers<M>) Fixed::get(padded.data(), message);
    const auto size = [&] {
      Reader reader(padded, fixed_size<M>);
      M::varying_members(message, reader, context...);
      return reader.size();
    };
    needed.size = size();
    FlagTrial trial{needed, body.size(),
                    [](const void* of) { return (*static_cast<decltype(size)*>(of))(); }, &size};
    (Context::visit(context, trial), ...);
    Meta<M>::visit(message, trial);
  }
  return needed;
}

inline NeededSize needed_size(Direction direction, std::uint8_t id,
                              std::span<const std::uint8_t> body, const Contexts& contexts) {
  NeededSize needed;
  const auto use = [&]<class M>(Type<M>) {
    if constexpr (HasContext<M>) {
      typename CodedAs<M>::Context context = contexts.of(M{});
      if constexpr (RepeatsContext<M>) {
        const auto own = repeated_flags<M>(body);
        auto& flags = context.*M::Context::repeated;
        if (flags.has(M::Context::repeats)) {
          flags.set(M::Context::repeats, false);
          if (own.has(M::Context::repeats)) flags = own;
        }
      }
      needed = needed_size<CodedAs<M>>(body, context);
    } else {
      needed = needed_size<CodedAs<M>>(body);
    }
  };
  select(direction, id, body.size(), use, contexts);
  return needed;
}

inline std::string bytes_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " byte" : " bytes");
}

/// Returns "26 bytes, the flags need 35", or "" if the size is not the problem.
inline std::string size_text(const Status& status, std::size_t body, const NeededSize& needed) {
  const bool is_size = status.code == Code::too_short || status.code == Code::too_long;
  if (!is_size || needed.size == 0 || needed.size == body) return "";
  std::string text = bytes_text(body);
  text += needed.depends_on_flags          ? ", the flags need "
          : status.code == Code::too_short ? ", the message needs "
                                           : ", the message has ";
  text += std::to_string(needed.size);
  if (*needed.without != '\0') {
    text += ", and " + std::to_string(body) + " without " + needed.without;
  }
  return text;
}

}  // namespace detail

/// Describes what arrived instead of a message: "26 bytes, the flags need 35, and 26 without
/// ENCODER_RAW24". `status` is the result of decoding the body with the same contexts.
inline std::string explain(const Status& status, Direction direction, std::uint8_t id,
                           std::span<const std::uint8_t> body, const Contexts& contexts = {}) {
  const detail::NeededSize needed = detail::needed_size(direction, id, body, contexts);
  std::string text = detail::size_text(status, body.size(), needed);
  return text.empty() ? detail::bytes_text(body.size()) + ": " + to_string(status) : text;
}

/// Returns why a board with these versions does not know the message, such as "needs firmware
/// 2.66" or "needs EXT_MOTORS"; "" if it does.
inline std::string objection_to(const MessageInfo& info, const Availability& versions) {
  const auto firmware = [](std::uint16_t version) {
    return to_string(msg::FirmwareVersion(version));
  };
  if (info.until.firmware != 0 && info.until.firmware <= versions.firmware) {
    return "needs firmware before " + firmware(info.until.firmware);
  }
  if (info.since.firmware > versions.firmware) {
    return "needs firmware " + firmware(info.since.firmware);
  }
  if (info.since.board > versions.board) {
    return "needs board " + to_string(msg::BoardVersion(info.since.board));
  }
  if ((info.since.features & versions.features) != 0) {
    return "needs " + feature_names(info.since.features);
  }
  return "";
}

}  // namespace sbgc
