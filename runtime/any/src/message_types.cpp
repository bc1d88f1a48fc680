// Everything that is compiled for each message; no other file of the library is.

#include <array>
#include <type_traits>

#include <sbgc/any.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/surplus.hpp>

#include "fixed_codec.hpp"

namespace sbgc {

namespace {

// Not lambdas: compilers make two functions of each one that is converted to a pointer.

template <class M>
Status decode_as(const detail::AnyOperations& /*of*/, std::span<const std::uint8_t> body,
                 void* message, const Contexts& contexts) {
  M& out = *static_cast<M*>(message);
  if constexpr (requires { typename M::Context; }) {
    return decode(body, out, contexts.of(out));
  } else {
    return decode(body, out);
  }
}
template <class M>
WriteResult encode_as(const detail::AnyOperations& /*of*/, const void* message,
                      std::span<std::uint8_t> out) {
  return encode(*static_cast<const M*>(message), out);
}
template <class M>
void teach_as(const void* message, Contexts& contexts) {
  contexts.learn(*static_cast<const M*>(message));
}

template <class M>
constexpr auto teacher_of() -> decltype(detail::AnyOperations::teach) {
  if constexpr (Contexts::learns_from<M>) {
    return teach_as<M>;
  } else {
    return nullptr;
  }
}

template <class M>
constexpr detail::AnyOperations operations_of() {
  detail::AnyOperations result{.construct = detail::construct<M>,
                               .decode = detail::decode_fixed,
                               .encode = detail::encode_fixed,
                               .teach = teacher_of<M>(),
                               .table = &detail::table_of<Received<M>>(),
                               .runs = {},
                               .size = sizeof(M),
                               .min_size = M::min_size,
                               .takes_surplus = takes_surplus<M>};
  if constexpr (detail::has_only_fixed<M>) {
    result.runs = detail::runs_of<M>;
  } else {
    result.decode = decode_as<M>;
    result.encode = encode_as<M>;
  }
  return result;
}
template <class M>
constexpr detail::AnyOperations operations = operations_of<M>();

template <class M>
constinit detail::FieldTypes fields_of{};

template <class M>
constexpr MessageType type_of() {
  using T = Received<M>;
  static_assert(std::is_trivially_copyable_v<T>, "AnyMessage copies the bytes");
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
  static_assert(!takes_surplus<M> || sizeof(M) <= detail::largest_with_surplus);
  return {.info = &Meta<M>::info,
          .form = M::form,
          .memory = sizeof(T),
          .operations = &operations<M>,
          .field_types = &fields_of<M>};
}

template <class M>
constexpr MessageType type_object = type_of<M>();

template <class... Ms>
constexpr auto types_in(TypeList<Ms...>) {
  return std::array{&type_object<Ms>...};
}
constexpr auto types = types_in(AllMessages{});

template <class... Ms>
constexpr auto functions_of(TypeList<Ms...>) {
  return std::array{&detail::message_type<Ms>...};
}
/// Makes the compiler emit message_type() for every message.
SBGC_USED constexpr auto functions = functions_of(AllMessages{});

}  // namespace

template <Message M>
const MessageType& detail::message_type() noexcept {
  return type_object<M>;
}

std::span<const MessageType* const> message_types() noexcept { return types; }

const MessageType* find_message(Direction direction, std::uint8_t id, std::size_t size,
                                const Contexts& contexts) noexcept {
  const MessageType* found = nullptr;
  const auto use = [&]<class M>(Type<M>) { found = &type_object<M>; };
  select_received(direction, id, size, use, contexts);
  return found;
}

}  // namespace sbgc
