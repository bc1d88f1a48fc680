#include "frames/frame_output.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "command/command_error.hpp"
#include "frames/frame_text.hpp"
#include "values/leaf_value.hpp"

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
  if (has_frames_ && !has_printed_) put_remark("none of them is selected\n");
}

void FrameOutput::put_csv(const DecodedFrame& decoded, const CapturePlace* place) {
  if (table_ == nullptr) {
    begin_table(decoded, place != nullptr ? SampleKey::time : SampleKey::offset);
  }
  require_same_columns(decoded);
  const double key =
      place != nullptr ? place->since_start : static_cast<double>(decoded.frame.offset);
  out_.put(table_->line(key, [&](const std::function<void(const Leaf&)>& use) {
    for_each_shown_value(decoded, [&](const Leaf& leaf, bool has_arrived) {
      if (has_arrived) use(leaf);
    });
  }));
}

void FrameOutput::begin_table(const DecodedFrame& decoded, SampleKey key) {
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

/// Throws CommandError for values that belong into none of the columns.
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

}  // namespace sbgc::tools
