// Fuzzes the JSON reader. The input is a line as `sbgc encode` reads it. Each is either a problem
// with its position, or the same value that nlohmann_json reads. That value is a message or a
// JsonError, and a message survives the round trip through JSON and bytes.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <sbgc/dispatch.hpp>
#include <sbgc/json.hpp>
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

template <class M>
void check(const sbgc::Json& fields) {
  M message{};
  try {
    sbgc::from_json(fields, message);
  } catch (const sbgc::JsonError&) {
    return;
  }
  const sbgc::Json printed = sbgc::to_json(message);
  M again{};
  sbgc::from_json(sbgc::Json::parse(printed.dump()), again);
  require(bytes_of(again) == bytes_of(message));
  require(sbgc::to_json(again) == printed);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const sbgc::ParsedJson parsed = sbgc::parse_json(text);
  if (parsed.problem) {
    require(parsed.problem->line > 0 && parsed.problem->column > 0);
    require(parsed.problem->column <= size + 1 && !parsed.problem->reason.empty());
    return 0;
  }
  const sbgc::Json& line = parsed.value;
  require(line.dump() == sbgc::Json::parse(text).dump());
  if (!line.is_object() || !line.contains("message") || !line.contains("fields")) return 0;
  sbgc::AllMessages::for_each([&]<class M>(sbgc::Type<M>) {
    if (line["message"] == sbgc::Meta<M>::info.name) check<M>(line["fields"]);
  });
  return 0;
}
