// The frame builder of the reference site: makes the frame of a message from the values of a form.
//
// build() reads lines of text: the name of the message; a frame in hex that has the values to start
// from, or an empty line for a new message; and for each field that is to change, its path, '=' and
// its value as `sbgc send` takes it. A path alone adds that field or element. The output is JSON:
//
//   {"fields": [...], "frame": "3e…", "problems": [[path, sentence], ...],
//    "warnings": [[path, sentence], ...], "lines": [[path, text, is secret], ...]}
//
// `fields` is described in message_form.hpp. `lines` make the message from a new one. With
// problems, there is no frame, and `frame` is "". Warnings are of values without a name.

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

#include "frames/json_string.hpp"
#include "values/complete_message.hpp"
#include "values/unnamed.hpp"
#include "modules/exchange.hpp"
#include "modules/message_form.hpp"

namespace sbgc::tools {

namespace {

/// A problem of a field, or of the message if the path is "".
using Problem = std::pair<std::string, std::string>;

/// Takes the next line from a text.
std::string_view take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

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

std::string frame_of(const AnyMessage& message, std::vector<Problem>& problems) {
  if (!problems.empty()) return "";
  std::array<std::uint8_t, max_frame_size> frame{};
  const WriteResult written = message.encode_frame(basic_framing, frame);
  if (written) return detail::to_hex(std::span(frame).first(written.size));
  problems.push_back(about(written.status.field, to_string(written.status)));
  return "";
}

void build(std::string_view input, std::string& output) {
  StringOutput out(output);
  const std::string_view name = take_line(input);
  const std::string_view start = take_line(input);
  const MessageType* const type = find_message(name);
  if (type == nullptr) {
    out.put(
        R"({"fields":[],"frame":"","lines":[],"warnings":[],"problems":[["","there is no such message"]]})");
    return out.finish();
  }
  AnyMessage message = new_message(*type);
  read_frame(start, message);
  std::vector<Problem> problems = assign_all(input, message);
  add_demanded(message);
  add_violations(message, problems);
  const std::string frame = frame_of(message, problems);
  const MessageForm form(message);
  out.put("{\"fields\":");
  form.put_fields(out);
  out.put(",\"frame\":");
  put_json_string(out, frame);
  std::vector<Problem> warnings;
  for_each_unnamed(message, [&](const std::string& path, const std::string& sentence) {
    warnings.emplace_back(path, sentence);
  });
  bool is_first = true;
  const auto separate = [&] {
    out.put(is_first ? "[" : ",[");
    is_first = false;
  };
  const auto put_list = [&](const char* begin, const std::vector<Problem>& list) {
    out.put(begin);
    is_first = true;
    for (const auto& [path, sentence] : list) {
      separate();
      put_json_string(out, path);
      out.put(',');
      put_json_string(out, sentence);
      out.put(']');
    }
  };
  put_list(",\"problems\":[", problems);
  put_list("],\"warnings\":[", warnings);
  out.put("],\"lines\":[");
  is_first = true;
  for (const FormLine& line : form.lines()) {
    separate();
    put_json_string(out, line.path);
    out.put(',');
    put_json_string(out, line.text);
    out.put(line.is_secret ? ",true]" : ",false]");
  }
  out.put("]}");
  out.finish();
}

}  // namespace
}  // namespace sbgc::tools

/// Makes the frame of the input.
SBGC_EXPORT(build) void sbgc_build() {
  auto& exchange = sbgc::tools::exchange();
  const std::string input(exchange.input.begin(), exchange.input.end());
  exchange.output.clear();
  sbgc::tools::build(input, exchange.output);
}
