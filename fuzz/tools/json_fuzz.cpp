// Fuzzes the JSON readers. The input is a line as `sbgc encode` reads it. parse_json() returns a
// problem with its position, or the same value that nlohmann_json reads. from_json() accepts the
// text of the fields if parse_json() and from_dom() do, and reads the same message. It survives the
// round trip through JSON and bytes.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/dispatch.hpp>
#include <sbgc/json.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parse_json.hpp>

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

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
  const std::string printed = sbgc::to_json(message);
  require(printed == sbgc::to_json(by_dom));
  require(sbgc::parse_json(printed).value == sbgc::to_dom(message));
  M again{};
  require(static_cast<bool>(sbgc::from_json(printed, again)));
  require(bytes_of(again) == bytes_of(message));
  require(sbgc::to_json(again) == printed);
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
  if (parsed.problem) {
    require(parsed.problem->line > 0 && parsed.problem->column > 0);
    require(parsed.problem->column <= text.size() + 1 && !parsed.problem->reason.empty());
    return;
  }
  require(parsed.value.dump() == sbgc::Json::parse(text).dump());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  check_line(text);
  // Found without a parser, so that they may be anything.
  const auto message = between(text, R"("message":")", '"');
  const auto fields = between(text, R"("fields":)", '}');
  if (!message || !fields) return 0;
  const std::string_view name = message->substr(0, message->find('"'));
  sbgc::AllMessages::for_each([&]<class M>(sbgc::Type<M>) {
    if (name == sbgc::Meta<M>::info.name) check<M>(*fields);
  });
  return 0;
}
