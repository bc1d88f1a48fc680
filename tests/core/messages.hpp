/// Messages of any type, for tests that iterate over all of them, and copies of what the library
/// reports about one.
#pragma once

#include <map>
#include <ostream>

#include <sbgc/any.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/validate.hpp>

#include "support.hpp"

namespace sbgc {

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
inline void PrintTo(const MessageType* type, std::ostream* out) { *out << type->info->name; }

}  // namespace sbgc

namespace sbgc::test {

/// A violation with its path as text, independent of the message.
struct ViolationCopy {
  std::string path;
  double value{};
  double limit{};
  Rule rule{};

  bool operator==(const ViolationCopy&) const = default;
};

/// Collects violations. Not a lambda, because each message would then instantiate its own
/// validator.
struct ViolationCopies {
  std::vector<ViolationCopy>& copies;

  void operator()(const Violation& violation) const {
    copies.push_back({to_string(violation.path), violation.value, violation.limit, violation.rule});
  }
};

/// Returns the violations of a message.
template <class M>
std::vector<ViolationCopy> violations_of(const M& message) {
  std::vector<ViolationCopy> result;
  validate(message, ViolationCopies{result});
  return result;
}
/// Without the quick check before it.
std::vector<ViolationCopy> violations_of(const AnyMessage& message,
                                         const Availability& versions = newest);
/// The result of the quick check alone.
bool passes_quick_check(const AnyMessage& message, const Availability& versions);

/// A leaf without its views.
struct LeafCopy {
  LeafKind kind{};
  std::int64_t integer{};
  double real{};
  ByteVector bytes{};  ///< of bytes or a text
  std::size_t offset{};
  std::size_t size{};
};
std::vector<LeafCopy> leaves_of(const AnyMessage& message);

/// Raw values by the specification's field name: one, or one for each axis or element.
using FieldValues = std::map<std::string, std::vector<double>>;
FieldValues spec_fields(const AnyMessage& message);

/// Returns the body, or an empty vector if the message does not encode.
ByteVector encoded_body(const AnyMessage& message);

/// By the function for the message's own type.
WriteResult typed_frame(const AnyMessage& message, std::span<std::uint8_t> out);

// Through the values of nlohmann_json, not through text.
Json dom_of(const AnyMessage& message);
void read_dom(const Json& json, AnyMessage& message);

inline bool is_of_fixed_size(const MessageType& type) {
  return type.info->min_size == type.info->max_size;
}

/// Returns the type with this name; throws if there is none.
const MessageType& message_type(const std::string& name);

/// The result of select().
struct Selected {
  Code code{};
  const MessageInfo* info{};  ///< null if there was no callback
};
Selected selected(Direction direction, std::uint8_t id, std::size_t size);

/// The result of visit_received().
struct Visited {
  Status status{};
  int calls{};
  const MessageInfo* info{};  ///< null if there was no callback
  Json fields{};
};
Visited visited(std::uint8_t id, std::span<const std::uint8_t> body, Direction direction,
                const Contexts& contexts = {});

/// Returns one of 64 contexts learned from random conversations.
const Contexts& random_contexts(std::size_t index);

}  // namespace sbgc::test
