// All that is compiled for each message: the only such file of the library.

#include <array>
#include <new>
#include <type_traits>

#include <sbgc/any.hpp>
#include <sbgc/internal/check.hpp>
#include <sbgc/internal/compiler.hpp>
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

/// Not lambdas: compilers make two functions of each that becomes a pointer.
template <class M, class T>
struct Operations {
  static const T& of(const void* message) { return *static_cast<const T*>(message); }
  static T& of(void* message) { return *static_cast<T*>(message); }

  static void construct(void* message) { new (message) T{}; }
  static void copy(const void* from, void* message) {
    new (message) T{*static_cast<const M*>(from)};
  }
  static bool equal(const void* message, const void* other) { return of(message) == of(other); }
  static Status decode(std::span<const std::uint8_t> body, void* message,
                       const Contexts& contexts) {
    T& out = of(message);
    if constexpr (requires { typename T::Context; }) {
      return sbgc::decode(body, out, contexts.of(out));
    } else {
      return sbgc::decode(body, out);
    }
  }
  static WriteResult encode(const void* message, std::span<std::uint8_t> out) {
    return sbgc::encode(of(message), out);
  }
  static void teach(const void* message, Contexts& contexts) {
    contexts.learn(without_surplus(of(message)));
  }
  static void leaves(const void* message, detail::LeafWalk& walk) {
    walk.members(of(message), nullptr);
  }
  static bool validate(const void* message, const Availability& versions,
                       detail::AnyOperations::UseViolation use, void* user) {
    // Not validate(), whose fast path is inlined: it takes as long to compile as all of this.
    const Report report{use, user};
    detail::Check<const Report> check(versions, report);
    check.members(of(message), nullptr);
    return check.passed();
  }
  static void write_json(const void* message, TextOutput& out, Secrets secrets) {
    sbgc::write_json(of(message), out, secrets);
  }
  static bool read_json(detail::JsonReader<detail::JsonTextSource>& reader, void* message) {
    return reader.message(of(message));
  }
  static void set(void* message, detail::FieldSetter& setter) { setter.members(of(message)); }
};

template <class M, class T>
constexpr auto teacher_of() -> decltype(detail::AnyOperations::teach) {
  if constexpr (Contexts::learns_from<M>) {
    return Operations<M, T>::teach;
  } else {
    return nullptr;
  }
}

template <class M, class T = Received<M>>
constexpr detail::AnyOperations operations_of = {
    .construct = Operations<M, T>::construct,
    .copy = Operations<M, T>::copy,
    .equal = Operations<M, T>::equal,
    .decode = Operations<M, T>::decode,
    .encode = Operations<M, T>::encode,
    .teach = teacher_of<M, T>(),
    .leaves = Operations<M, T>::leaves,
    .validate = Operations<M, T>::validate,
#ifndef SBGC_ANY_WITHOUT_JSON  // the frame builder of the reference site, which readers download
    .write_json = Operations<M, T>::write_json,
    .read_json = Operations<M, T>::read_json,
#endif
    .set = Operations<M, T>::set,
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

const MessageType* find_message(Direction direction, std::uint8_t id, std::size_t size,
                                const Contexts& contexts) noexcept {
  const MessageType* found = nullptr;
  const auto use = [&]<class M>(Type<M>) { found = &type_object<M>; };
  select_received(direction, id, size, use, contexts);
  return found;
}

}  // namespace sbgc
