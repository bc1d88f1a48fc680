#include "frames/frame_output.hpp"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/value_text.hpp>

#include "command/command_error.hpp"
#include "command/remark.hpp"
#include "command/wording.hpp"
#include "frames/frame_text.hpp"
#include "values/field_lookup.hpp"
#include "values/leaf_value.hpp"
#include "values/message_names.hpp"

namespace sbgc::tools {

namespace {

/// Calls `use(leaf, has_arrived)` for the values, which show secrets if the frame does.
template <class Use>
void for_each_shown_value(const DecodedFrame& decoded, const Use& use) {
  for_each_value(decoded, [&](Leaf leaf, bool has_arrived) {
    leaf.secrets = decoded.secrets;
    use(leaf, has_arrived);
  });
}

/// Returns the member "values" of a JSON line: each value with its meaning, by path.
std::string values_text(const DecodedFrame& decoded) {
  if (!has_values(decoded)) return "";
  Json values = Json::object();
  for_each_shown_value(decoded, [&](const Leaf& leaf, bool has_arrived) {
    if (has_arrived && !is_unused(leaf)) values[to_string(leaf.path)] = leaf_json(leaf);
  });
  return ",\"values\":" + detail::json_text(values);
}

std::string unit_name(const Leaf& leaf) { return leaf.unit == nullptr ? "" : leaf.unit->name; }

}  // namespace

FrameOutput::FrameOutput(const FrameOutputOptions& options, StandardOutput& out)
    : options_(options), out_(out), new_decoder_(wanted(), options.versions) {}

FrameDecoder::Wanted FrameOutput::wanted() const {
  const bool needs_fields = options_.real || options_.filter.needs_fields();
  return {.json = !is_text() || needs_fields, .rows = is_text(), .secrets = options_.secrets};
}

bool FrameOutput::print(const Frame& frame, std::optional<Direction> direction,
                        std::string_view heading, const CapturePlace* place) {
  const DecodedFrame decoded = decoder_.decode(frame, direction);
  has_frames_ = true;
  if (decoded.status) ++readable_;
  if (!options_.filter.is_empty() && !options_.filter.wants(decoded)) return false;
  has_printed_ = true;
  switch (options_.format) {
    case OutputFormat::text:
      out_.put(heading);
      put_text(out_, decoded, colors_);
      return true;
    case OutputFormat::jsonl:
      put_json(out_, decoded, place, options_.real ? values_text(decoded) : "");
      out_.put('\n');
      return true;
    case OutputFormat::csv:
      if (!has_values(decoded)) return false;
      put_csv(decoded, place);
      return true;
  }
  return false;
}

void FrameOutput::end() {
  if (!has_frames_ || has_printed_) return;
  put_remark("none of them is selected\n");
  if (options_.format == OutputFormat::csv) end_empty_table();
}

void FrameOutput::end_empty_table() {
  remark("sbgc: none of the frames is selected\n");
  DecodedFrame none;
  none.message = options_.filter.known_table();
  if (none.message != nullptr) begin_table(none);
}

void FrameOutput::put_csv(const DecodedFrame& decoded, const CapturePlace* place) {
  if (table_ == nullptr) begin_table(decoded);
  require_same_columns(decoded);
  const double key =
      place != nullptr ? place->since_start : static_cast<double>(decoded.frame.offset);
  out_.put(table_->line(key, [&](const std::function<void(const Leaf&)>& use) {
    for_each_shown_value(decoded, [&](const Leaf& leaf, bool has_arrived) {
      if (has_arrived) use(leaf);
    });
  }));
}

void FrameOutput::begin_table(const DecodedFrame& decoded) {
  const SampleKey key = has_times_ ? SampleKey::time : SampleKey::offset;
  std::vector<StreamField> columns;
  for_each_value(decoded, [&](const Leaf& leaf, bool) {
    if (leaf.field.reserved) return;
    columns.push_back({to_string(leaf.path), unit_name(leaf)});
    table_units_.emplace(columns.back().path, columns.back().unit);
  });
  table_message_ = decoded.message;
  table_ = SampleWriter::make(OutputFormat::csv, table_message_->name, std::move(columns), 0, key);
  out_.put(table_->header());
}

/// Throws CommandError for values that fit into none of the columns.
void FrameOutput::require_same_columns(const DecodedFrame& decoded) const {
  if (table_message_ != decoded.message) {
    throw CommandError(fmt::format(
        "a table in CSV holds one kind of message, but there are {} and {}; choose with --message",
        table_message_->name, decoded.message->name));
  }
  for_each_value(decoded, [&](const Leaf& leaf, bool has_arrived) {
    if (leaf.field.reserved || !has_arrived) return;
    const auto column = table_units_.find(to_string(leaf.path));
    if (column != table_units_.end() && column->second == unit_name(leaf)) return;
    throw CommandError(fmt::format(
        "a table in CSV has the columns of its first frame, but {} of {} is {}; choose a part with "
        "--from and --to, or use --format jsonl",
        to_string(leaf.path), table_message_->name,
        column == table_units_.end() ? "new here" : "in another unit here"));
  });
}

namespace {

/// Returns the fields of a message that the name denotes; none if it has no such field.
std::vector<FoundField> fields_named(const MessageType& message, const std::string& name) {
  try {
    return find_fields(message.fields(), name);
  } catch (const ValueError&) {
    return {};  // an index is missing, or the name fits different fields
  }
}

}  // namespace

bool FieldCondition::Target::means(std::string_view path) const {
  return std::ranges::any_of(
      paths, [&](const std::string& one) { return detail::is_in_field(path, one); });
}

FieldCondition::FieldCondition(const std::string& text) {
  // The longer operators first: they begin with the shorter ones.
  constexpr std::pair<std::string_view, Operator> operators[] = {
      {"!=", Operator::unequal}, {"<=", Operator::most}, {">=", Operator::least},
      {"=", Operator::equal},    {"<", Operator::less},  {">", Operator::greater},
      {"&", Operator::has},
  };
  const std::size_t place = text.find_first_of("=<>!&");
  const auto* const found = std::ranges::find_if(operators, [&](const auto& one) {
    return place != std::string::npos &&
           std::string_view(text).substr(place).starts_with(one.first);
  });
  if (found == std::end(operators) || place == 0) {
    throw ValueError(fmt::format(
        "'{}' is no condition; write FIELD, then =, !=, <, <=, >, >= or & (has the flag), then a "
        "value",
        clipped(text)));
  }
  name_ = detail::trimmed(std::string_view(text).substr(0, place));
  operator_ = found->second;
  value_ = detail::trimmed(std::string_view(text).substr(place + found->first.size()));
  // A typo must not look like a capture without such frames.
  std::vector<FieldSource> sources;
  std::string problem;
  for (const MessageType* const message : message_types()) {
    sources.push_back({message->info->name, &message->fields()});
    const std::string why_not = add_target(*message);
    if (problem.empty()) problem = why_not;
  }
  if (!targets_.empty()) return;
  if (!problem.empty()) throw ValueError(problem);
  throw ValueError(fmt::format("no message has a field '{}'{}", clipped(name_),
                               detail::did_you_mean(similar_fields(sources, name_))));
}

/// Adds the fields of a message that the name denotes. Returns why the condition is impossible.
std::string FieldCondition::add_target(const MessageType& message) {
  Target target;
  for (const FoundField& field : fields_named(message, name_)) {
    const FieldType& type = field.type->innermost();
    const std::string path = steps_text(field.steps);
    if (type.shape == FieldShape::group) {
      return fmt::format("{} of {} is a group; name one of its fields", path, message.info->name);
    }
    ParsedValue parsed =
        parse_value(type, type.unit, value_, static_cast<std::uint64_t>(type.initial));
    if (!parsed) return fmt::format("{} of {}: {}", path, message.info->name, parsed.problem);
    target.value = std::move(parsed.value);
    target.paths.push_back(path);
  }
  if (!target.paths.empty()) targets_.emplace(message.info, std::move(target));
  return {};
}

template <class Number>
bool FieldCondition::compare(Number value, Number with) const {
  switch (operator_) {
    case Operator::equal: return value == with;
    case Operator::unequal: return value != with;
    case Operator::less: return value < with;
    case Operator::most: return value <= with;
    case Operator::greater: return value > with;
    case Operator::least: return value >= with;
    case Operator::has: break;
  }
  const auto bits = static_cast<std::int64_t>(with);
  return (static_cast<std::int64_t>(value) & bits) == bits && bits != 0;
}

bool FieldCondition::holds(const DecodedFrame& frame) const {
  const auto found = targets_.find(frame.message);
  if (found == targets_.end()) return false;
  const Target& target = found->second;
  bool result = false;
  for_each_value(frame, [&](const Leaf& leaf, bool has_arrived) {
    if (result || !has_arrived || !target.means(to_string(leaf.path))) return;
    if (const auto* const integer = std::get_if<std::int64_t>(&target.value)) {
      result = compare(leaf.integer, *integer);
    } else if (const auto* const real = std::get_if<double>(&target.value)) {
      result = compare(leaf.real, *real);
    } else {
      const auto* const text = std::get_if<std::string>(&target.value);
      const auto* const bytes = std::get_if<std::vector<std::uint8_t>>(&target.value);
      const bool is_equal = text != nullptr    ? leaf.text == *text
                            : bytes != nullptr ? raw_text(leaf) == detail::to_hex(*bytes)
                                               : false;
      result =
          operator_ == Operator::unequal ? !is_equal : operator_ == Operator::equal && is_equal;
    }
  });
  return result;
}

void FrameFilter::add_message(const std::string& name) {
  if (const auto id = parse_command_id(name)) {
    ids_.push_back(*id);
    return;
  }
  const std::size_t before = messages_.size();
  for (const Direction direction : {Direction::to_board, Direction::from_board}) {
    for (const MessageType* const type : messages_named(name, direction)) {
      messages_.push_back(type->info);
    }
  }
  if (messages_.size() == before) {
    throw ValueError(
        fmt::format("there is no message '{}'{}", clipped(name), similar_messages(name)));
  }
}

void FrameFilter::add_condition(const std::string& text) {
  const FieldCondition& added = conditions_.emplace_back(text);
  const bool can_hold = std::ranges::any_of(
      messages_, [&](const MessageInfo* message) { return added.concerns(*message); });
  if (can_hold || messages_.empty() || !ids_.empty()) return;
  throw ValueError(fmt::format("the selected messages have no such field: '{}'", clipped(text)));
}

const MessageInfo* FrameFilter::known_table() const {
  const MessageInfo* found = nullptr;
  for (const MessageInfo* const message : messages_) {
    std::vector<FieldType> fields = find_message(message->name)->fields();
    std::erase_if(fields, [](const FieldType& field) { return field.is_tail(); });
    if (fields.empty() || message == found) continue;
    const bool varies = std::ranges::any_of(
        fields, [](const FieldType& field) { return field.is_optional || field.size == 0; });
    if (varies || found != nullptr) return nullptr;
    found = message;
  }
  return ids_.empty() ? found : nullptr;
}

bool FrameFilter::wants(const DecodedFrame& frame) const {
  const bool is_named = std::ranges::find(messages_, frame.message) != messages_.end() ||
                        std::ranges::find(ids_, frame.frame.id) != ids_.end();
  if (!is_named && !(messages_.empty() && ids_.empty())) return false;
  if (conditions_.empty()) return true;
  if (!has_values(frame)) return false;
  return std::ranges::all_of(conditions_,
                             [&](const FieldCondition& one) { return one.holds(frame); });
}

bool has_values(const DecodedFrame& frame) {
  return frame.message != nullptr && !frame.fields.empty();
}

const MessageType& type_of(const DecodedFrame& frame) { return *find_message(frame.message->name); }

void for_each_value(const DecodedFrame& frame, const std::function<void(const Leaf&, bool)>& use) {
  AnyMessage message = type_of(frame).make();
  static_cast<void>(message.from_json(frame.values));
  message.for_each_leaf(
      [&](const Leaf& leaf) { use(leaf, leaf.offset + leaf.size <= frame.certain); });
}

}  // namespace sbgc::tools
