// Fuzzes the JSON readers. The input is lines as `sbgc encode` reads them, with bombs (see
// hostile_text.hpp); the time is in proportion to their size. parse_json() returns a problem with
// its position, or the same value that nlohmann_json reads. from_json() accepts the text of the
// fields if parse_json() and from_dom() do, and reads the same message. It survives the round trip
// through JSON and bytes. encode_line() returns a frame or throws an error with a message.

#include <stdexcept>

#include <sbgc/dispatch.hpp>
#include <sbgc/json.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parse_json.hpp>
#include <sbgc/parser.hpp>

#include "frames/encode_line.hpp"
#include "hostile_text.hpp"
#include "input.hpp"

namespace {

using sbgc::fuzz::require;

template <class M>
std::vector<std::uint8_t> bytes_of(const M& message) {
  std::vector<std::uint8_t> out(sbgc::max_body_size);
  out.resize(sbgc::encode(message, out).size);
  return out;
}

/// Reads a message by way of a DOM.
template <class M>
bool read_by_dom(std::string_view text, M& message) {
  const sbgc::ParsedJson parsed = sbgc::parse_json(text);
  if (!parsed) return false;
  try {
    sbgc::from_dom(parsed.value, message);
  } catch (const sbgc::JsonError& error) {
    require(std::string_view(error.what()).starts_with(error.field()));
    return false;
  }
  return true;
}

template <class M>
void check(std::string_view fields) {
  M message{};
  M by_dom{};
  const sbgc::JsonResult read = sbgc::from_json(fields, message);
  require(static_cast<bool>(read) == read_by_dom(fields, by_dom));
  require(bytes_of(message) == bytes_of(by_dom));
  if (!read) {
    require(!read.problem->reason.empty() && read.problem->line > 0);
    require(read.problem->column > 0 && read.problem->column <= fields.size() + 1);
    return;
  }
  constexpr auto shown = sbgc::Secrets::shown;
  const std::string printed = sbgc::to_json(message, shown);
  require(printed == sbgc::to_json(by_dom, shown));
  require(sbgc::parse_json(printed).value == sbgc::to_dom(message, shown));
  M again{};
  require(static_cast<bool>(sbgc::from_json(printed, again)));
  require(bytes_of(again) == bytes_of(message));
  require(sbgc::to_json(again, shown) == printed);
}

/// Returns the text after `start` up to the last `end`.
std::optional<std::string_view> between(std::string_view text, std::string_view start, char end) {
  const std::size_t at = text.find(start);
  const std::size_t last = text.rfind(end);
  if (at == std::string_view::npos || last == std::string_view::npos) return std::nullopt;
  const std::size_t from = at + start.size();
  if (last < from) return std::nullopt;
  return text.substr(from, last - from);
}

void check_line(std::string_view text) {
  const sbgc::ParsedJson parsed = sbgc::parse_json(text);
  if (!parsed.problem) return;
  require(parsed.problem->line > 0 && parsed.problem->column > 0);
  require(parsed.problem->column <= text.size() + 1 && !parsed.problem->reason.empty());
}

/// Compares the value with that of nlohmann_json, whose time grows with the square of the keys.
void compare_values(std::string_view text) {
  constexpr std::size_t longest = 8192;
  if (text.size() > longest) return;
  const sbgc::ParsedJson parsed = sbgc::parse_json(text);
  if (parsed) require(parsed.value.dump() == sbgc::Json::parse(text).dump());
}

void check_fields_of(std::string_view line) {
  // Found without a parser, so that they may be anything.
  const auto message = between(line, R"("message":")", '"');
  const auto fields = between(line, R"("fields":)", '}');
  if (!message || !fields) return;
  const std::string_view name = message->substr(0, message->find('"'));
  sbgc::AllMessages::for_each([&]<class M>(sbgc::Type<M>) {
    if (name == sbgc::Meta<M>::info.name) check<M>(*fields);
  });
}

void check_encoding(const std::string& line, const sbgc::tools::EncodeRules& rules) {
  try {
    const std::vector<std::uint8_t> bytes = sbgc::tools::encode_line(line, rules);
    std::size_t frames = 0;
    sbgc::ParserOfAll parser;
    parser.feed(bytes, [&](const sbgc::Frame&) { ++frames; });
    require(frames == 1 && parser.counters().skipped_bytes == 0);
  } catch (const std::runtime_error& error) {
    require(*error.what() != '\0');
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = sbgc::fuzz::text_with_bombs({data, size});
  std::string_view rest = text;
  do {
    const std::string line(rest.substr(0, rest.find('\n')));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    sbgc::fuzz::require_linear_time(line.size(), std::chrono::microseconds(20), [&] {
      check_line(line);
      check_fields_of(line);
      check_encoding(line, {});
      check_encoding(line, {.no_validate = true, .defaults = true});
    });
    compare_values(line);
  } while (!rest.empty());
  return 0;
}
