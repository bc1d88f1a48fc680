/// The form of a message: its fields with their values, as texts that people edit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/any.hpp>

#include "modules/json_writer.hpp"

namespace sbgc::tools {

/// A value that a message is given, as AnyMessage::assign() takes it.
struct FormLine {
  std::string path{};
  std::string text{};
  bool is_secret{};
  bool is_in_unit{};  ///< other values may select its unit, and are assigned before it
};

/// The types of the fields by path, in which [] stands for each index.
using FieldTypes = std::map<std::string, const FieldType*, std::less<>>;
FieldTypes types_of(const MessageType& type);
/// Returns a path with [] for each index.
std::string without_indices(std::string_view path);

class MessageForm {
 public:
  /// The message must outlive the form.
  explicit MessageForm(const AnyMessage& message);

  /// Writes a JSON list of fields. Each is {"path", "name", "kind", …}:
  ///
  ///     group, axes     "fields"
  ///     list            "fields", one for each element; "grows" with the most, if it can grow
  ///     enum, flags     "value", "names"
  ///     packed          "value"; "parts", each with "name", "kind", "value", "names" and "unit"
  ///     number, numbers, text, bytes     "value", "unit", "hint"
  ///
  /// "optional" is set for what may be missing; its value is then "".
  void put_fields(web::JsonWriter& out) const;

  /// Returns the assignments that make this message from a new one, in a valid order.
  std::vector<FormLine> lines() const;

 private:
  /// The present and initial text of a value in the message.
  struct Value {
    std::string text{};
    std::string initial{};  ///< the text in a new message
    std::int64_t raw{};
    const UnitInfo* unit{};
  };
  void read(const AnyMessage& message);
  const Value* value_at(const std::string& path) const;
  std::size_t size_at(const std::string& path) const;
  /// Returns the values of a list with commas between them.
  std::string joined(const std::string& path, bool is_initial) const;

  void put(web::JsonWriter& out, const FieldType& type, const std::string& name,
           const std::string& path, bool is_optional) const;
  void put_members(web::JsonWriter& out, const std::vector<FieldType>& members,
                   const std::string& path, bool is_optional) const;
  void put_elements(web::JsonWriter& out, const FieldType& type, const std::string& path,
                    bool is_optional) const;
  void put_value(web::JsonWriter& out, const FieldType& type, const std::string& path) const;
  void add_lines(std::vector<FormLine>& lines, const FieldType& type, const std::string& path,
                 bool is_always) const;

  const AnyMessage& message_;
  FieldTypes types_{};
  std::map<std::string, Value, std::less<>> values_{};
  std::map<std::string, std::size_t, std::less<>> sizes_{};  // of lists
};

}  // namespace sbgc::tools
