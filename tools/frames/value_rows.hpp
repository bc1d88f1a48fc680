/// The values of a message in readable form.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/text.hpp>

namespace sbgc::tools {

/// The text of a path.
class PathText {
 public:
  /// Returns false if it was another path before.
  bool assign(const FieldPath& path) {
    if (is_of(path)) return true;
    replace(path);
    return false;
  }
  std::string_view text() const { return text_; }

 private:
  /// The path from the innermost name on. Names are literals, so equal pointers are equal names.
  struct Level {
    const char* name{};
    std::size_t index{};
  };
  static constexpr std::size_t most_levels = 6;

  bool is_of(const FieldPath& path) const {
    const Level* level = levels_.data();
    for (const FieldPath* at = &path; at != nullptr; at = at->parent, ++level) {
      if (at->name != level->name || at->index != level->index) return false;
    }
    return level->name == nullptr;
  }
  void replace(const FieldPath& path);

  std::array<Level, most_levels + 1> levels_{};  // ends with an empty one
  std::string text_{};
};

/// One value of a message.
struct Row {
  PathText path{};
  std::string objection{};  ///< violation of the specification, such as "is below 1 Hz", or with
                            ///< its own subject, "MODE_RC needs firmware 2.66"
  std::size_t offset{};     ///< offset of the value in the body
  std::size_t size{};       ///< size of the value in bytes

  std::string_view raw() const { return std::string_view(text).substr(0, raw_size); }
  /// Returns the value in its unit, or its name.
  std::string_view meaning() const { return std::string_view(text).substr(raw_size); }

  /// What decides the texts of a value that is an integer.
  struct Source {
    bool is_integer{};
    std::int64_t integer{};
    const UnitInfo* unit{};
    const LaterMeaning* assumed_before{};
    bool operator==(const Source&) const = default;
  };

  // The texts, which stay while the value does.
  Source source{};
  std::string text{};  ///< raw value and meaning
  std::size_t raw_size{};
  std::string unnamed{};  ///< the objection that a value has no name, or ""
};

using Rows = std::span<const Row>;

/// The values of one message after another. Keeps its memory.
class ValueRows {
 public:
  /// Replaces the rows by those of a message, without reserved values that are 0. They mean what
  /// they do on a board of the versions `meant`; objections are those of the versions `allowed`.
  void assign(const AnyMessage& message, const Availability& allowed, const Availability& meant,
              Secrets secrets = Secrets::hidden);

  /// Returns the rows, valid until the next message.
  Rows rows() const { return {rows_->data(), size_}; }

 private:
  void add(const Leaf& leaf, StringOutput& out);
  void write(Row& row, const Leaf& leaf, StringOutput& out) const;
  void put_secret(Leaf leaf, StringOutput& out) const;
  void object(const Violation& violation);

  // The paths of a message, and many of its values, do not change from one frame to the next.
  std::unordered_map<const MessageType*, std::vector<Row>> rows_of_messages_;
  std::vector<Row>* rows_ = nullptr;  // of the message, the first size_
  std::size_t size_ = 0;
  Secrets secrets_{};
  std::size_t objected_ = 0;  // the last row that has an objection
  std::string text_;          // of the values that have changed
};

/// Returns what to say of an enum value that has no name: "has no name; the nearest are
/// CMD_REALTIME_DATA_3 (23) and CMD_REALTIME_DATA_4 (25)"; "" for any other value. It is no error:
/// other firmware may know it.
///
/// A 0 without a name is none of the values, which is usual in what a board sends or stores; unless
/// `takes_zero`, there is something to say about it.
std::string unnamed_text(const Leaf& leaf, bool takes_zero = true);

/// Calls `use(path, sentence)` for the values of a request that have no name: "24 has no name; the
/// nearest ...".
template <class Message, class Use>
void for_each_unnamed(const Message& message, const Use& use) {
  const bool is_stored = *message.type().info->stores != '\0';
  message.for_each_leaf([&](const Leaf& leaf) {
    const std::string text = unnamed_text(leaf, is_stored);
    if (!text.empty()) use(to_string(leaf.path), raw_text(leaf) + ' ' + text);
  });
}

}  // namespace sbgc::tools
