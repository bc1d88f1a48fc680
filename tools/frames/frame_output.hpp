/// The output of `sbgc decode`, and the selection of frames.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/any.hpp>

#include "command/input_output.hpp"
#include "command/terminal_text.hpp"
#include "frames/decoded_frame.hpp"
#include "frames/sample_writer.hpp"

namespace sbgc::tools {

/// A condition on a field, such as "angle.pitch > 10deg". For axes or a list, such as "angle", it
/// holds if any of their values satisfies it.
class FieldCondition {
 public:
  /// Throws ValueError if it is malformed, or no message has such a field that accepts the value.
  explicit FieldCondition(const std::string& text);

  /// True if the message has a field that the condition names.
  bool concerns(const MessageInfo& message) const { return targets_.contains(&message); }

  /// True if a field that the condition names has arrived and satisfies it.
  bool holds(const DecodedFrame& frame) const;

 private:
  enum class Operator : std::uint8_t { equal, unequal, less, most, greater, least, has };
  /// The fields of one message that the name denotes, and the value to compare with.
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

/// All conditions of a command line; a frame must satisfy all of them.
class FrameFilter {
 public:
  /// Selects messages by name: the own name, that of the command, or its id. Throws ValueError,
  /// with suggestions, if there is no such message.
  void add_message(const std::string& name);
  /// Must be called after the messages are selected. Throws ValueError if none of them can satisfy
  /// the condition.
  void add_condition(const std::string& text);

  /// Returns the only selected message with values, if they are the same in all bodies; otherwise
  /// null.
  const MessageInfo* known_table() const;

  bool is_empty() const { return messages_.empty() && ids_.empty() && conditions_.empty(); }
  /// True if fields() of a decoded frame are needed.
  bool needs_fields() const { return !conditions_.empty(); }

  bool wants(const DecodedFrame& frame) const;

 private:
  std::vector<const MessageInfo*> messages_{};
  std::vector<std::uint8_t> ids_{};
  std::vector<FieldCondition> conditions_{};
};

/// True if a frame that was decoded with JSON has values; a truncated body may have some.
bool has_values(const DecodedFrame& frame);

/// Returns the type of the message. Precondition: has_values(frame).
const MessageType& type_of(const DecodedFrame& frame);

/// Calls `use(leaf, has_arrived)` for each value. In a truncated body, values that did not arrive
/// are 0. Precondition: has_values(frame).
void for_each_value(const DecodedFrame& frame, const std::function<void(const Leaf&, bool)>& use);

/// The frames to print, and their format.
struct FrameOutputOptions {
  OutputFormat format = OutputFormat::text;
  bool real = false;                       ///< JSON lines also have the values in their units
  Secrets secrets{};                       ///< whether they are shown
  std::optional<Availability> versions{};  ///< of the firmware to check against
  FrameFilter filter{};
};

/// Prints frames one after another. Text that is not about a frame goes to put_remark().
class FrameOutput {
 public:
  FrameOutput(const FrameOutputOptions& options, StandardOutput& out);

  bool is_text() const { return options_.format == OutputFormat::text; }

  /// Decodes a frame, and prints it unless the filter rejects it. Frames of a capture have a place.
  /// `heading` precedes the text of a frame. Returns true if it was printed.
  bool print(const Frame& frame, std::optional<Direction> direction, std::string_view heading,
             const CapturePlace* place = nullptr);
  /// Updates the context with a frame that is not printed, for decoding later ones.
  void learn(const Frame& frame, Direction direction) {
    if (decoder_.decode(frame, direction).status) ++readable_;
    has_frames_ = true;
  }
  /// True if there were frames, but none could be decoded.
  bool is_unreadable() const { return has_frames_ && readable_ == 0; }
  /// Reports in the formats for people if no frame was selected; the table in CSV gets its header.
  void end();
  /// Begins a session of a capture, and forgets the context of earlier frames.
  void begin_session() {
    decoder_ = new_decoder_;
    has_times_ = true;
  }

  /// Prints text, in the text format only.
  void put_remark(std::string_view text) {
    if (is_text()) out_.put(text);
  }

 private:
  FrameDecoder::Wanted wanted() const;
  void put_csv(const DecodedFrame& decoded, const CapturePlace* place);
  void begin_table(const DecodedFrame& decoded);
  void end_empty_table();
  void require_same_columns(const DecodedFrame& decoded) const;

  FrameOutputOptions options_;
  StandardOutput& out_;
  Colors colors_{stdout};
  bool has_frames_ = false;
  bool has_printed_ = false;
  bool has_times_ = false;      // of a capture
  std::uint64_t readable_ = 0;  // the number of frames that can be decoded
  FrameDecoder new_decoder_;
  FrameDecoder decoder_ = new_decoder_;
  std::unique_ptr<SampleWriter> table_{};  // of the first message in CSV
  const MessageInfo* table_message_ = nullptr;
  std::map<std::string, std::string> table_units_{};  // of the columns, by path
};

}  // namespace sbgc::tools
