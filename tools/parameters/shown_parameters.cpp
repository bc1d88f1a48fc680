#include "parameters/shown_parameters.hpp"

#include <fmt/format.h>

#include <sbgc/text.hpp>

#include "parameters/parameter_blocks.hpp"
#include "values/search_words.hpp"

namespace sbgc::tools {

std::string ShownParameter::text() const {
  if (meaning.empty()) return raw;
  return is_special ? fmt::format("{} ({})", raw, meaning) : meaning;
}

std::string ShownParameter::short_text() const {
  constexpr std::size_t longest = 32;
  constexpr std::size_t shown = 16;
  if (bytes <= longest) return text();
  return fmt::format("{}… ({} bytes)", raw.substr(0, 2 * shown), bytes);
}

std::vector<ShownParameter> shown_parameters(const Parameters& block,
                                             const Availability& versions) {
  std::vector<ShownParameter> result;
  auto add = [&](const Leaf& leaf) {
    if (!is_settable(leaf.field) || leaf.kind == LeafKind::counter) return;
    ShownParameter shown{.message = block.id.message,
                         .path = to_string(leaf.path),
                         .spec_name = leaf.field.spec_name,
                         .raw = raw_text(leaf),
                         .meaning = meaning_text(leaf),
                         .is_special = special_meaning(leaf) != nullptr,
                         .is_general = leaf.field.role == FieldRole::general,
                         .summary = leaf.field.summary,
                         .topics = topics_of(leaf.field)};
    const bool is_number = leaf.kind == LeafKind::integer || leaf.kind == LeafKind::real;
    if (is_number && leaf.names == nullptr && leaf.packed == nullptr && !shown.is_special) {
      const double raw =
          leaf.kind == LeafKind::real ? leaf.real : static_cast<double>(leaf.integer);
      shown.value = leaf.unit != nullptr ? leaf.unit->real(raw) : raw;
    }
    if (leaf.kind == LeafKind::bytes) shown.bytes = leaf.bytes.size();
    if (leaf.unit != nullptr) shown.unit = leaf.unit->name;
    result.push_back(std::move(shown));
  };
  message_in(block).for_each_leaf(add, versions);
  return result;
}

Json to_json(const ShownParameter& parameter) {
  Json result{{"message", parameter.message}, {"path", parameter.path}, {"raw", parameter.raw}};
  result["value"] = parameter.value ? Json(*parameter.value) : Json();
  result["unit"] = parameter.unit.empty() ? Json() : Json(parameter.unit);
  result["meaning"] = parameter.meaning.empty() ? Json() : Json(parameter.meaning);
  result["general"] = parameter.is_general;
  result["topics"] = Json::array();
  for (const TopicReference* const topic : parameter.topics) {
    result["topics"].push_back(topic->name);
  }
  if (!parameter.other_default.empty()) result["default"] = parameter.other_default;
  return result;
}

}  // namespace sbgc::tools
