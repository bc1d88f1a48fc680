#include "values/leaf_value.hpp"

#include <cmath>

#include <fmt/format.h>

#include <sbgc/internal/characters.hpp>
#include <sbgc/json/values.hpp>

namespace sbgc::tools {

namespace {

std::string shortest(double value, bool is_float) {
  return is_float ? fmt::format("{}", static_cast<float>(value)) : fmt::format("{}", value);
}

}  // namespace

std::optional<double> real_value(const Leaf& leaf) {
  if (leaf.kind == LeafKind::bytes || leaf.kind == LeafKind::text) return std::nullopt;
  if (special_meaning(leaf) != nullptr) return std::nullopt;
  const double raw = leaf.kind == LeafKind::real ? leaf.real : static_cast<double>(leaf.integer);
  const double real = leaf.unit == nullptr ? raw : leaf.unit->real(raw);
  if (!std::isfinite(real)) return std::nullopt;
  return real;
}

std::string real_text(const Leaf& leaf) {
  const std::optional<double> real = real_value(leaf);
  if (!real) return {};
  const bool is_scaled = leaf.unit != nullptr && !leaf.unit->is_plain();
  if (leaf.kind != LeafKind::real && !is_scaled) return raw_text(leaf);
  return shortest(*real, leaf.kind == LeafKind::real && leaf.size == sizeof(float));
}

std::string csv_text(std::string_view text) {
  std::string result;
  // As in JSON, invalid UTF-8 is mapped to the private use area.
  const std::string utf8 = detail::to_utf8(text);
  detail::for_each_sequence(utf8, [&](std::string_view sequence, bool) {
    const char32_t c = detail::code_point(sequence);
    if (!detail::is_control(c)) {
      result += sequence == "\"" ? "\"\"" : sequence;
    } else if (sequence.size() == 1) {
      result += fmt::format("\\x{:02x}", static_cast<unsigned>(c));
    } else {
      result += detail::escaped(c);
    }
  });
  const bool is_special = text.find_first_of(",\"") != std::string_view::npos;
  return is_special ? '"' + result + '"' : result;
}

std::string csv_cell(const Leaf& leaf) {
  if (is_hidden(leaf)) return hidden_text;
  if (leaf.kind == LeafKind::text) return csv_text(leaf.text);
  return leaf.kind == LeafKind::bytes ? raw_text(leaf) : real_text(leaf);
}

Json leaf_json(const Leaf& leaf) {
  Json json = Json::object();
  switch (leaf.kind) {
    case LeafKind::integer:
    case LeafKind::counter: json["raw"] = leaf.integer; break;
    case LeafKind::real:
      // JSON has no NaN.
      json["raw"] = std::isfinite(leaf.real) ? Json(leaf.real) : Json(nullptr);
      break;
    case LeafKind::bytes: json["raw"] = raw_text(leaf); break;
    case LeafKind::text: json["raw"] = is_hidden(leaf) ? hidden_text : leaf.text; break;
  }
  if (leaf.kind == LeafKind::integer && leaf.is_u64) {
    json["raw"] = static_cast<std::uint64_t>(leaf.integer);
  }
  const std::optional<double> real = real_value(leaf);
  if (leaf.unit != nullptr && *leaf.unit->name != '\0') {
    if (real) json["real"] = *real;
    json["unit"] = leaf.unit->name;
  } else if (leaf.unit != nullptr && !leaf.unit->is_plain() && real) {
    json["real"] = *real;
  }
  const bool is_named = leaf.unit == nullptr || special_meaning(leaf) != nullptr;
  Leaf certain = leaf;
  certain.assumed_before = nullptr;
  if (std::string meaning = is_named ? meaning_text(certain) : ""; !meaning.empty()) {
    json["text"] = meaning;
  }
  if (leaf.assumed_before != nullptr) json["assumes"] = assumption_text(leaf);
  return json;
}

}  // namespace sbgc::tools
