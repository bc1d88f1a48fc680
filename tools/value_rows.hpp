/// The values of a message in readable form.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <sbgc/text.hpp>

namespace sbgc::tools {

/// One value of a message.
struct Row {
  std::string_view path;
  std::string_view raw;
  std::string_view meaning;  ///< the value in its unit, or its name
  std::string objection;     ///< violation of the specification, such as "is below 1 Hz", or with
                             ///< its own subject, "MODE_RC needs firmware 2.66"
  std::size_t offset{};      ///< offset of the value in the body
  std::size_t size{};        ///< size of the value in bytes
};

/// The text of a path, as long as the path stays the same.
class PathText {
 public:
  /// Returns the text of `path`, valid until the path changes.
  std::string_view of(const FieldPath& path);

 private:
  /// The path from the innermost name on. Names are literals, so equal pointers are equal names.
  struct Level {
    const char* name{};
    std::size_t index{};
  };

  bool is_of(const FieldPath& path) const;

  std::array<Level, 6> levels_{};
  std::string text_{};
};

/// The values of one message after another. Keeps its memory.
class ValueRows {
 public:
  /// Replaces the rows by those of a message, without reserved values that are 0.
  template <class M>
  void assign(const M& message, const Availability& versions) {
    begin(Meta<M>::info);
    {
      StringOutput out(text_);
      for_each_leaf(message, Adder{*this, out});
      out.finish();
    }
    end();
    validate(message, versions, Objector{*this});
  }
  void clear() { size_ = 0; }

  std::span<const Row> rows() const { return {rows_.data(), size_}; }

 private:
  /// Where the texts of a row are, one after another.
  struct Place {
    std::size_t raw;
    std::size_t meaning;
    std::size_t end;
  };

  struct Adder {
    ValueRows& rows;
    StringOutput& out;

    void operator()(const Leaf& leaf) const { rows.add(leaf, out); }
  };
  struct Objector {
    ValueRows& rows;

    void operator()(const Violation& violation) const { rows.object(violation); }
  };

  void begin(const MessageInfo& info);
  void add(const Leaf& leaf, StringOutput& out);
  void end();
  void object(const Violation& violation);

  // The paths of a message rarely change from one frame to the next.
  std::unordered_map<const MessageInfo*, std::deque<PathText>> paths_of_messages_;
  std::deque<PathText>* paths_ = nullptr;  // of the message
  std::string text_;
  std::vector<Place> places_;
  std::vector<Row> rows_;  // the first size_
  std::size_t size_ = 0;
};

}  // namespace sbgc::tools
