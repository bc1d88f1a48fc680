/// Messages from JSON text: from_json(text, message). Include the tables of the messages:
/// <sbgc/meta/control.hpp>, for example, or <sbgc/meta/all.hpp>.
#pragma once

#include <optional>
#include <string_view>

#include <sbgc/internal/table.hpp>
#include <sbgc/json/problem.hpp>
#include <sbgc/json/reader.hpp>
#include <sbgc/json/text_source.hpp>

namespace sbgc {

/// The result of reading a message from JSON; true in a condition if it succeeded.
struct [[nodiscard]] JsonResult {
  std::optional<JsonProblem> problem{};  ///< why the text is rejected

  /// True if the message was read.
  explicit operator bool() const noexcept { return !problem; }
};

namespace detail {

/// Reads a message with this table. After a problem, its values are unspecified.
inline JsonResult read_json(std::string_view text, const StructTable& table, void* message) {
  JsonTextSource source(text);
  JsonReader<JsonTextSource> reader(source);
  if (reader.message(table, message) && source.finish()) return {};
  // Invalid JSON is reported first.
  const char* const no_json = source.problem();
  return {JsonProblem{source.line(source.at()), source.column(source.at()),
                      no_json != nullptr ? no_json : reader.reason(),
                      no_json != nullptr ? "" : reader.field()}};
}

}  // namespace detail

/// Reads `message` from `text`, which must contain nothing else and may be untrusted. A problem
/// leaves the message unchanged. Uses no heap unless there is a problem, and never throws.
///
/// Every field is required, except optional ones, counters of lists and the tail. A counter that is
/// present must match its list.
template <class M>
JsonResult from_json(std::string_view text, M& message) {
  M read{};
  JsonResult result = detail::read_json(text, detail::table_of<M>(), &read);
  if (result) message = read;
  return result;
}

}  // namespace sbgc
