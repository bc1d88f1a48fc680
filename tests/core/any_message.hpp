/// One interface to every message, so that a test can iterate over all of them without
/// instantiating a template for each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/dispatch.hpp>
#include <sbgc/json.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/text/leaves.hpp>
#include <sbgc/validate.hpp>

#include "support.hpp"

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
    char path[128] = {};
    violation.path.write(path, sizeof path);
    copies.push_back({path, violation.value, violation.limit, violation.rule});
  }
};

/// Returns the violations of a message.
template <class M>
std::vector<ViolationCopy> violations_of(const M& message) {
  std::vector<ViolationCopy> result;
  validate(message, ViolationCopies{result});
  return result;
}

/// A leaf without its views.
struct LeafCopy {
  LeafKind kind{};
  std::int64_t integer{};
  double real{};
  ByteVector bytes{};  ///< of bytes or a text
  std::size_t offset{};
  std::size_t size{};
};

/// Raw values by the specification's field name: one, or one for each axis or element.
using FieldValues = std::map<std::string, std::vector<double>>;

/// A message of any type, with the surplus that a request may have.
class AnyMessage {
 public:
  AnyMessage() = default;
  AnyMessage(const AnyMessage&) = delete;
  AnyMessage(AnyMessage&&) = delete;
  AnyMessage& operator=(const AnyMessage&) = delete;
  AnyMessage& operator=(AnyMessage&&) = delete;
  virtual ~AnyMessage() = default;

  virtual Status decode(std::span<const std::uint8_t> body, const Contexts& contexts) = 0;
  virtual WriteResult encode(std::span<std::uint8_t> out) const = 0;
  virtual WriteResult encode_frame(std::span<std::uint8_t> out) const = 0;
  /// Like operator==; `other` must have the same type.
  virtual bool equals(const AnyMessage& other) const = 0;
  virtual void teach(Contexts& contexts) const = 0;
  virtual std::size_t tail_size() const = 0;
  virtual std::vector<ViolationCopy> violations() const = 0;
  /// The violations that the walk over all members reports, without the quick check before it.
  virtual std::vector<ViolationCopy> walk(const Availability& versions) const = 0;
  /// The result of the quick check alone.
  virtual bool is_plainly_valid(const Availability& versions) const = 0;
  virtual FieldValues spec_fields() const = 0;
  virtual std::vector<LeafCopy> leaves() const = 0;
  virtual Json to_dom() const = 0;
  virtual void from_dom(const Json& json) = 0;
  virtual std::string to_json() const = 0;
  virtual JsonResult from_json(std::string_view text) = 0;

  Status decode(std::span<const std::uint8_t> body) { return decode(body, Contexts{}); }
  /// Returns the body, or an empty vector if the message does not encode.
  ByteVector body() const;
};

/// A message type.
struct MessageType {
  const MessageInfo* info{};
  Form form{};
  std::unique_ptr<AnyMessage> (*make)(){};

  bool fixed_size() const { return info->min_size == info->max_size; }
};

/// Returns all message types, in the order of AllMessages.
const std::vector<MessageType>& message_types();

/// Returns the type with this name; fails the test if there is none.
const MessageType& message_type(const std::string& name);

/// The result of select().
struct Selected {
  Code code{};
  const MessageInfo* info{};  ///< null if there was no callback
};
Selected selected(Direction direction, std::uint8_t id, std::size_t size);

/// Returns the type that select_received() chooses, or null if there is none.
const MessageType* find_message_type(Direction direction, std::uint8_t id, std::size_t size);

/// The result of visit_received().
// NOLINTNEXTLINE(bugprone-exception-escape): nlohmann's move does not throw
struct Visited {
  Status status{};
  int calls{};
  const MessageInfo* info{};  ///< null if there was no callback
  Json fields{};
};
Visited visited(std::uint8_t id, std::span<const std::uint8_t> body, Direction direction,
                const Contexts& contexts = {});

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
inline void PrintTo(const MessageType& type, std::ostream* out) { *out << type.info->name; }

/// Returns one of 64 contexts learned from random conversations.
const Contexts& random_contexts(std::size_t index);

}  // namespace sbgc::test
