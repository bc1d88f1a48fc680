/// The codec of messages whose bodies all have the same members, by their tables.
#pragma once

#include <cstdint>
#include <span>

#include <sbgc/any.hpp>

namespace sbgc::detail {

/// True for messages that consist of fixed members, and perhaps a tail.
template <class M>
inline constexpr bool has_only_fixed =
    !HasVaryingMembers<CodedAs<M>> && !HasTaggedUnions<CodedAs<M>>;

Status decode_fixed(const AnyOperations& of, std::span<const std::uint8_t> body, void* message,
                    const Contexts& contexts);
WriteResult encode_fixed(const AnyOperations& of, const void* message, std::span<std::uint8_t> out);

}  // namespace sbgc::detail
