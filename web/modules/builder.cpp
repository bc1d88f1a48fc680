// The frame builder of the reference site: makes the frame of a message from the values of a form.
//
// build() reads lines of text: the name of the message; a frame in hex that has the values to start
// from, or an empty line for a new message; and for each field that is to change, its path, '=' and
// its value as `sbgc send` takes it. A path alone adds that field or element. The output is JSON:
//
//   {"frame": "3e…", "problems": [[path, sentence], ...], "fields": [...],
//    "warnings": [[path, sentence], ...], "lines": [[path, text, is secret], ...]}
//
// `fields` is described in message_form.hpp. `lines` make the message from a new one. With
// problems, there is no frame, and `frame` is "". Warnings are of values without a name.
//
// encode() reads the name of a message; "newest" or "basic" for the framing; lines PATH=VALUE; an
// empty line; and the message in JSON, to which the lines are assigned. Its output has "frame" and
// "problems" alone. defaults() reads a name and paths, one a line, and writes the JSON of a new
// message with these fields and elements. names() lists all messages.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/text.hpp>

#include "frames/value_rows.hpp"
#include "modules/exchange.hpp"
#include "modules/json_writer.hpp"
#include "modules/message_form.hpp"
#include "values/complete_message.hpp"

namespace sbgc::tools {

namespace {

using web::JsonWriter;

/// A problem of a field, or of the message if the path is "".
using Problem = std::pair<std::string, std::string>;

constexpr const char* no_message = "there is no such message";

std::string_view take_line(std::string_view& text) { return web::take_until('\n', text); }

/// Returns a sentence about a field without the path at its start.
Problem about(std::string_view path, const std::string& sentence) {
  const std::string start = std::string(path) + ": ";
  const bool is_about = sentence.starts_with(start);
  return {is_about ? std::string(path) : "", is_about ? sentence.substr(start.size()) : sentence};
}

/// Reads the values of a message from a frame. Leaves the message as it was if they do not fit.
void read_frame(std::string_view hex, AnyMessage& message) {
  const auto bytes = detail::from_hex(hex);
  if (!bytes) return;
  ParserOfAll parser;
  parser.feed(*bytes, [&](const Frame& frame) {
    AnyMessage decoded = message.type().make();
    if (decoded.decode(frame.body)) message = std::move(decoded);
  });
}

/// Gives the message its values. Those that select the unit of others may come after these.
std::vector<Problem> assign_all(std::string_view lines, AnyMessage& message) {
  std::vector<Problem> problems;
  for (const bool is_last : {false, true}) {
    for (std::string_view rest = lines; !rest.empty();) {
      const std::string_view line = take_line(rest);
      const std::string_view path = line.substr(0, line.find('='));
      if (path.empty()) continue;
      if (path == line) {
        message.add(path);
        continue;
      }
      const std::string problem = message.assign(path, line.substr(path.size() + 1), false);
      if (is_last && !problem.empty()) problems.push_back(about(path, problem));
    }
  }
  return problems;
}

/// Adds what the specification does not allow.
void add_violations(const AnyMessage& message, std::vector<Problem>& problems) {
  message.validate(newest, [&](const Violation& violation) {
    problems.push_back(about(to_string(violation.path), to_string(violation)));
  });
}

std::string frame_of(const AnyMessage& message, std::vector<Problem>& problems,
                     Framing framing = basic_framing) {
  if (!problems.empty()) return "";
  std::array<std::uint8_t, max_frame_size> frame{};
  const WriteResult written = message.encode_frame(framing, frame);
  if (written) return detail::to_hex(std::span(frame).first(written.size));
  const std::string_view field = written.status.field;
  if (written.status.code == Code::presence_mismatch && message.has(field)) {
    problems.emplace_back(field, "another value of the message, such as a flag, excludes it");
  } else {
    problems.push_back(about(field, to_string(written.status)));
  }
  return "";
}

void put_list(JsonWriter& out, const std::vector<Problem>& list) {
  out.list([&] {
    for (const auto& [path, sentence] : list) out.values(path, sentence);
  });
}

/// Writes the members "frame" and "problems".
void put_result(JsonWriter& out, const std::string& frame, const std::vector<Problem>& problems) {
  out.member("frame", frame);
  put_list(out.key("problems"), problems);
}

/// Writes the members about the message that the values make.
void put_built(JsonWriter& out, AnyMessage message, std::string_view lines) {
  std::vector<Problem> problems = assign_all(lines, message);
  add_demanded(message);
  add_violations(message, problems);
  put_result(out, frame_of(message, problems), problems);
  const MessageForm form(message);
  form.put_fields(out.key("fields"));
  std::vector<Problem> warnings;
  for_each_unnamed(message, [&](const std::string& path, const std::string& sentence) {
    warnings.emplace_back(path, sentence);
  });
  put_list(out.key("warnings"), warnings);
  out.key("lines").list([&] {
    for (const FormLine& line : form.lines()) out.values(line.path, line.text, line.is_secret);
  });
}

void build(std::string_view input, JsonWriter& out) {
  const std::string_view name = take_line(input);
  const std::string_view start = take_line(input);
  const MessageType* const type = find_message(name);
  if (type == nullptr) {
    put_result(out, "", {{"", no_message}});
    for (const char* const none : {"fields", "lines", "warnings"}) out.key(none).values();
    return;
  }
  AnyMessage message = new_message(*type);
  read_frame(start, message);
  put_built(out, std::move(message), input);
}

/// Makes the frame of a message in JSON, without its warnings and its form.
void encode(std::string_view input, JsonWriter& out) {
  std::vector<Problem> problems;
  std::string frame;
  const MessageType* const type = find_message(take_line(input));
  const Framing framing = take_line(input) == "newest" ? framings.back() : basic_framing;
  const std::string_view rest = input;
  while (!take_line(input).empty()) {
  }
  const std::string_view lines = rest.substr(0, rest.size() - input.size());
  if (type == nullptr) {
    problems.emplace_back("", no_message);
  } else {
    AnyMessage message = type->make();
    const auto read = message.from_json(input);
    if (read.problem) {
      // The caller has not seen the lines and columns of this JSON.
      problems.emplace_back(read.problem->field, read.problem->reason);
    } else {
      problems = assign_all(lines, message);
      add_demanded(message);
      add_violations(message, problems);
      frame = frame_of(message, problems, framing);
    }
  }
  put_result(out, frame, problems);
}

std::string defaults_of(const MessageType& type, std::string_view paths) {
  AnyMessage message = new_message(type);
  assign_all(paths, message);
  std::string json = message.to_json();
  for (const FieldType& field : type.fields()) {
    if (!field.is_counter) continue;
    const std::size_t at = json.find('"' + std::string(field.name) + "\":");
    const std::size_t end = json.find_first_of(",}", at);
    if (end < json.size()) json.erase(at, end - at + (json[end] == ',' ? 1 : 0));
  }
  return json;
}

/// The output is the object whose members `put` writes.
void answer(void (*put)(std::string_view input, JsonWriter& out)) {
  exchange().output.clear();
  JsonWriter out(exchange().output);
  out.object([&] { put(web::input_text(), out); });
}

}  // namespace
}  // namespace sbgc::tools

/// Makes the frame of the input.
SBGC_EXPORT(build) void sbgc_build() { sbgc::tools::answer(sbgc::tools::build); }

/// Makes the frame of a message in JSON.
SBGC_EXPORT(encode) void sbgc_encode() { sbgc::tools::answer(sbgc::tools::encode); }

/// Writes a new message as JSON, without the counters of lists; nothing if there is no such
/// message.
SBGC_EXPORT(defaults) void sbgc_defaults() {
  std::string_view paths = sbgc::web::input_text();
  const sbgc::MessageType* const type = sbgc::find_message(sbgc::tools::take_line(paths));
  sbgc::tools::exchange().output = type == nullptr ? "" : sbgc::tools::defaults_of(*type, paths);
}

/// Lists the names of all messages, one a line, '>' before those that are sent to the board.
SBGC_EXPORT(names) void sbgc_names() {
  std::string& names = sbgc::tools::exchange().output;
  names.clear();
  for (const sbgc::MessageType* const type : sbgc::message_types()) {
    names += type->is_sent_to_board() ? ">" : "<";
    names += type->info->name;
    names += '\n';
  }
}
