/// Selects frames by what they are and what they hold.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/any.hpp>

#include "frames/decoded_frame.hpp"

namespace sbgc::tools {

/// A condition on a field, such as "angle.pitch > 10deg". For axes or a list, such as "angle", it
/// holds if it does for any of their values.
class FieldCondition {
 public:
  /// Throws ValueError if it is malformed, or no message has such a field that takes the value.
  explicit FieldCondition(const std::string& text);

  /// True if the message has a field that the condition means.
  bool concerns(const MessageInfo& message) const { return targets_.contains(&message); }

  /// True if a field that the condition means arrived and holds such a value.
  bool holds(const DecodedFrame& frame) const;

 private:
  enum class Operator : std::uint8_t { equal, unequal, less, most, greater, least, has };
  /// The fields of one message that the name means, and the value to compare with.
  struct Target {
    std::vector<std::string> paths{};
    AnyValue value{};

    bool means(std::string_view path) const;
  };

  std::string add_target(const MessageType& message);
  template <class Number>
  bool compare(Number value, Number with) const;

  std::string name_{};
  Operator operator_{};
  std::string value_{};
  std::map<const MessageInfo*, Target> targets_{};
};

/// All conditions of a command line, of which every one must hold.
class FrameFilter {
 public:
  /// Selects messages by name: ours, that of the command, or its id. Throws ValueError, with
  /// suggestions, if there is no such message.
  void add_message(const std::string& name);
  /// To be called after the messages are selected. Throws ValueError if the condition can hold for
  /// none of them.
  void add_condition(const std::string& text);

  bool is_empty() const { return messages_.empty() && ids_.empty() && conditions_.empty(); }
  /// True if fields() of a decoded frame are needed.
  bool needs_fields() const { return !conditions_.empty(); }

  bool wants(const DecodedFrame& frame) const;

 private:
  std::vector<const MessageInfo*> messages_{};
  std::vector<std::uint8_t> ids_{};
  std::vector<FieldCondition> conditions_{};
};

/// True if a frame that was decoded with JSON has values: all, or of a short body some.
bool has_values(const DecodedFrame& frame);

/// Returns the type of the message. Precondition: has_values(frame).
const MessageType& type_of(const DecodedFrame& frame);

/// Calls `use(leaf, has_arrived)` for each value. Of a body that is too short, values that did not
/// arrive are 0. Precondition: has_values(frame).
void for_each_value(const DecodedFrame& frame, const std::function<void(const Leaf&, bool)>& use);

}  // namespace sbgc::tools
