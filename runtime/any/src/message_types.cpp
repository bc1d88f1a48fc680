// All that is compiled for each message: the only such file of the library.

#include <array>
#include <new>
#include <type_traits>

#include <sbgc/any.hpp>
#include <sbgc/json.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/validate.hpp>

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

template <class T>
constexpr detail::AnyOperations operations_of = {
    .construct = [](void* message) { new (message) T{}; },
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
    .teach =
        [](const void* message, Contexts& contexts) {
          contexts.learn(without_surplus(*static_cast<const T*>(message)));
        },
    .leaves =
        [](const void* message, detail::LeafWalk& walk) {
          walk.members(*static_cast<const T*>(message), nullptr);
        },
    .validate =
        [](const void* message, const Availability& versions,
           detail::AnyOperations::UseViolation use, void* user) {
          return sbgc::validate(*static_cast<const T*>(message), versions, Report{use, user});
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
          .operations = &operations_of<T>};
}

template <class M>
constexpr MessageType type_object = type_of<M>();

template <class... Ms>
constexpr auto types_in(TypeList<Ms...>) {
  return std::array{&type_object<Ms>...};
}
constexpr auto types = types_in(AllMessages{});

}  // namespace

std::span<const MessageType* const> message_types() noexcept { return types; }

const MessageType* find_message(Direction direction, std::uint8_t id, std::size_t size) noexcept {
  const MessageType* found = nullptr;
  select_received(direction, id, size, [&]<class M>(Type<M>) { found = &type_object<M>; });
  return found;
}

}  // namespace sbgc
