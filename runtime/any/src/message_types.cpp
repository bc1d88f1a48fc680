// All that is compiled for each message: the only such file of the library.

#include <array>
#include <new>
#include <type_traits>

#include <sbgc/any.hpp>
#include <sbgc/detail/check.hpp>
#include <sbgc/detail/compiler.hpp>
#include <sbgc/json.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/surplus.hpp>

#include "field_setter.hpp"
#include "field_types.hpp"

namespace sbgc {

namespace {

/// One type for all messages: each would be compiled for each of them.
struct Report {
  detail::AnyOperations::UseViolation use;
  void* user;

  void operator()(const Violation& violation) const { use(user, violation); }
};

template <class M, class T>
constexpr auto teacher_of() -> decltype(detail::AnyOperations::teach) {
  if constexpr (!Contexts::learns_from<M>) {
    return nullptr;
  } else {
    return [](const void* message, Contexts& contexts) {
      contexts.learn(without_surplus(*static_cast<const T*>(message)));
    };
  }
}

template <class M, class T = Received<M>>
constexpr detail::AnyOperations operations_of = {
    .construct = [](void* message) { new (message) T{}; },
    .copy = [](const void* from, void* message) { new (message) T{*static_cast<const M*>(from)}; },
    .equal =
        [](const void* message, const void* other) {
          return *static_cast<const T*>(message) == *static_cast<const T*>(other);
        },
    .decode =
        [](std::span<const std::uint8_t> body, void* message, const Contexts& contexts) {
          T& out = *static_cast<T*>(message);
          if constexpr (requires { typename T::Context; }) {
            return sbgc::decode(body, out, contexts.of(out));
          } else {
            return sbgc::decode(body, out);
          }
        },
    .encode =
        [](const void* message, std::span<std::uint8_t> out) {
          return sbgc::encode(*static_cast<const T*>(message), out);
        },
    .teach = teacher_of<M, T>(),
    .leaves =
        [](const void* message, detail::LeafWalk& walk) {
          walk.members(*static_cast<const T*>(message), nullptr);
        },
    .validate =
        [](const void* message, const Availability& versions,
           detail::AnyOperations::UseViolation use, void* user) {
          // Not validate(), whose fast path is inlined: it takes as long to compile as all of this.
          const Report report{use, user};
          detail::Check<const Report> check(versions, report);
          check.members(*static_cast<const T*>(message), nullptr);
          return check.passed();
        },
#ifndef SBGC_ANY_WITHOUT_JSON  // the frame builder of the reference site, which readers download
    .write_json =
        [](const void* message, TextOutput& out, Secrets secrets) {
          sbgc::write_json(*static_cast<const T*>(message), out, secrets);
        },
    .read_json = [](std::string_view text,
                    void* message) { return sbgc::from_json(text, *static_cast<T*>(message)); },
#endif
    .set = [](void* message,
              detail::FieldSetter& setter) { setter.members(*static_cast<T*>(message)); },
};

template <class T>
const std::vector<FieldType>& fields_of() {
  static const std::vector<FieldType> fields = detail::field_types<T>();
  return fields;
}

template <class M>
constexpr MessageType type_of() {
  using T = Received<M>;
  static_assert(std::is_trivially_copyable_v<T>, "AnyMessage copies the bytes");
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
  return {.info = &Meta<M>::info,
          .form = M::form,
          .memory = sizeof(T),
          .fields = fields_of<T>,
          .operations = &operations_of<M>};
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

const MessageType* find_message(Direction direction, std::uint8_t id, std::size_t size) noexcept {
  const MessageType* found = nullptr;
  select_received(direction, id, size, [&]<class M>(Type<M>) { found = &type_object<M>; });
  return found;
}

}  // namespace sbgc
