/// The values of a message in readable form.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
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
  /// Returns false if the path has changed.
  bool assign(const FieldPath& path) {
    if (is_of(path)) return true;
    replace(path);
    return false;
  }
  std::string_view text() const { return text_; }

  bool is_of(const FieldPath& path) const {
    const Level* level = levels_.data();
    for (const FieldPath* at = &path; at != nullptr; at = at->parent, ++level) {
      if (level->name == nullptr || at->index != level->index) return false;
      // Names are literals, which usually have the same address.
      if (at->name != level->name && std::strcmp(at->name, level->name) != 0) return false;
    }
    return level->name == nullptr;
  }

 private:
  /// The path, starting with the innermost name.
  struct Level {
    const char* name{};
    std::size_t index{};
  };
  static constexpr std::size_t most_levels = 6;

  void replace(const FieldPath& path);

  std::array<Level, most_levels + 1> levels_{};  // ends with an empty one
  std::string text_{};
};

/// One value of a message. Its raw value and its meaning are texts of Rows.
struct Row {
  /// The properties that determine the texts of an integer.
  struct Source {
    bool is_integer{};
    std::int64_t integer{};
    const UnitInfo* unit{};
    const LaterMeaning* assumed_before{};
    bool operator==(const Source&) const = default;
  };

  PathText path{};
  Source source{};
  std::string unnamed{};    ///< the objection that a value has no name, or ""
  std::string objection{};  ///< violation of the specification, such as "is below 1 Hz", or with
                            ///< its own subject, "MODE_RC needs firmware 2.66"
  std::size_t offset{};     ///< offset of the value in the body
  std::size_t size{};       ///< size of the value in bytes
  // The positions of the texts, one after another.
  std::size_t raw{};
  std::size_t meaning{};
  std::size_t end{};
};

/// The values of one message.
class Rows {
 public:
  Rows() = default;
  Rows(std::span<const Row> rows, const char* text) : rows_(rows), text_(text) {}

  bool empty() const { return rows_.empty(); }
  Rows first(std::size_t count) const { return {rows_.first(count), text_}; }
  auto begin() const { return rows_.begin(); }
  auto end() const { return rows_.end(); }

  std::string_view raw(const Row& row) const { return {text_ + row.raw, row.meaning - row.raw}; }
  /// Returns the value in its unit, or its name.
  std::string_view meaning(const Row& row) const {
    return {text_ + row.meaning, row.end - row.meaning};
  }

 private:
  std::span<const Row> rows_{};
  const char* text_ = "";
};

/// The values of one message after another. Reuses its memory.
class ValueRows {
 public:
  /// Replaces the rows by those of a message, without reserved zeros. Values are interpreted as on
  /// a board with the versions `meant`; objections are for the versions `allowed`.
  void assign(const AnyMessage& message, const Availability& allowed, const Availability& meant,
              Secrets secrets = Secrets::hidden);

  /// Returns the rows, valid until the next message.
  Rows rows() const { return {last_->rows, last_->text.data()}; }

 private:
  /// The last message of a type. The paths, and many of the values, are the same in consecutive
  /// frames.
  struct Last {
    std::vector<Row> rows{};
    std::string text{};
    std::string text_before{};  ///< of the previous message
  };

  void add(const Leaf& leaf, StringOutput& out);
  void write(Row& row, const Leaf& leaf, StringOutput& out) const;
  void put_secret(Leaf leaf, StringOutput& out) const;
  void object(const Violation& violation);

  std::unordered_map<const MessageType*, Last> messages_;
  Last* last_ = nullptr;
  std::size_t size_ = 0;  // of the rows in use
  Secrets secrets_{};
  std::size_t objected_ = 0;  // the last row that has an objection
};

/// Returns a remark on an enum value without a name: "has no name; the nearest are
/// CMD_REALTIME_DATA_3 (23) and CMD_REALTIME_DATA_4 (25)"; "" for any other value. It is not an
/// error: other firmware may know the value.
///
/// An unnamed 0 means no value, which is usual in what a board sends or stores; unless
/// `takes_zero`, it causes a remark as well.
std::string unnamed_text(const Leaf& leaf, bool takes_zero = true);

/// Calls `use(path, sentence)` for the values of a request without a name: "24 has no name; the
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
