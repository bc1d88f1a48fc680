#include "frames/sample_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include <sbgc/json_dom.hpp>

#include "values/leaf_value.hpp"

namespace sbgc::tools {

namespace {

/// The positions of the fields of a sample by their paths.
class FieldPlaces {
 public:
  explicit FieldPlaces(const std::vector<StreamField>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) places_[fields[i].path] = i;
  }

  /// Calls `use(place, leaf)` for the values of a sample that have a position.
  template <class Use>
  void for_each(const Sample& sample, const Use& use) const {
    sample([&](const Leaf& leaf) {
      const auto place = places_.find(to_string(leaf.path));
      if (place != places_.end()) use(place->second, leaf);
    });
  }

 private:
  std::unordered_map<std::string, std::size_t> places_;
};

const char* name(SampleKey key) {
  switch (key) {
    case SampleKey::time: return "time[s]";
    case SampleKey::unix_time: return "unix_time[s]";
    case SampleKey::offset: return "offset";
  }
  return "";
}

class CsvWriter final : public SampleWriter {
 public:
  CsvWriter(std::vector<StreamField> fields, SampleKey key)
      : fields_(std::move(fields)), places_(fields_), key_(key) {}

  std::string header() const override {
    std::string text = name(key_);
    for (const StreamField& field : fields_) {
      text += ',' + csv_text(field.unit.empty() ? field.path
                                                : fmt::format("{}[{}]", field.path, field.unit));
    }
    return text + '\n';
  }
  std::string line(double time, const Sample& sample) const override {
    std::vector<std::string> cells(fields_.size());
    places_.for_each(sample,
                     [&](std::size_t place, const Leaf& leaf) { cells[place] = csv_cell(leaf); });
    std::string text = fmt::format("{:.{}f}", time, key_ == SampleKey::offset ? 0 : 6);
    for (const std::string& cell : cells) text += ',' + cell;
    return text + '\n';
  }

 private:
  std::vector<StreamField> fields_;
  FieldPlaces places_;
  SampleKey key_;
};

class JsonWriter final : public SampleWriter {
 public:
  JsonWriter(std::string message, const std::vector<StreamField>& fields)
      : message_(std::move(message)), places_(fields) {}

  std::string header() const override { return {}; }
  std::string line(double time, const Sample& sample) const override {
    Json fields = Json::object();
    places_.for_each(sample, [&](std::size_t, const Leaf& leaf) {
      fields[to_string(leaf.path)] = leaf_json(leaf);
    });
    // Microseconds are precise enough.
    const Json json{{"version", 1},
                    {"time", std::round(time * 1e6) / 1e6},
                    {"message", message_},
                    {"fields", fields}};
    return detail::json_text(json) + '\n';
  }

 private:
  std::string message_;
  FieldPlaces places_;
};

/// The lines of a title: "angle.", "pitch" and "[deg]", or everything in the last one.
using Title = std::array<std::string, 3>;

/// A table whose columns are as wide as their titles, which are split into several lines if they do
/// not all fit into one.
class TableWriter final : public SampleWriter {
 public:
  TableWriter(std::vector<StreamField> fields, std::size_t width, SampleKey key)
      : fields_(std::move(fields)),
        places_(fields_),
        key_(name(key)),
        key_width_(key == SampleKey::unix_time ? 14 : 9) {
    add_columns(width, whole_title);
    if (widths_.size() == fields_.size()) return;
    titles_.clear();
    widths_.clear();
    add_columns(width, title_in_lines);
  }

  std::string header() const override {
    std::string text;
    for (std::size_t line = 0; line < Title().size(); ++line) {
      const bool is_last = line + 1 == Title().size();
      const bool is_empty =
          std::ranges::all_of(titles_, [&](const Title& title) { return title[line].empty(); });
      if (is_empty && !is_last) continue;
      text += fmt::format("{:>{}}", is_last ? key_ : "", key_width_);
      for (std::size_t i = 0; i < widths_.size(); ++i) {
        text += fmt::format("  {:>{}}", titles_[i][line], widths_[i]);
      }
      text += '\n';
    }
    const std::size_t hidden = fields_.size() - widths_.size();
    if (hidden != 0) {
      text +=
          fmt::format("({} more field{}: choose with --fields)\n", hidden, hidden == 1 ? "" : "s");
    }
    return text;
  }
  std::string line(double time, const Sample& sample) const override {
    std::vector<std::string> cells(fields_.size(), "-");
    places_.for_each(sample, [&](std::size_t place, const Leaf& leaf) {
      if (place < widths_.size()) cells[place] = cell(leaf);
    });
    std::string text = fmt::format("{:>{}.3f}", time, key_width_);
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      text += fmt::format("  {:>{}}", cells[i], widths_[i]);
    }
    return text + '\n';
  }

 private:
  static constexpr std::size_t least_width = 8;

  static Title whole_title(const StreamField& field) { return {"", "", field.path + unit(field)}; }
  static Title title_in_lines(const StreamField& field) {
    const std::size_t end = field.path.rfind('.') + 1;
    return {field.path.substr(0, end), field.path.substr(end), unit(field)};
  }
  static std::string unit(const StreamField& field) {
    return field.unit.empty() ? "" : fmt::format("[{}]", field.unit);
  }

  /// Adds the columns that fit, at least one.
  template <class TitleOf>
  void add_columns(std::size_t width, TitleOf title_of) {
    std::size_t used = key_width_;
    for (const StreamField& field : fields_) {
      Title title = title_of(field);
      std::size_t needed = least_width;
      for (const std::string& line : title) needed = std::max(needed, line.size());
      used += 2 + needed;
      if (width != 0 && used > width && !widths_.empty()) return;
      titles_.push_back(std::move(title));
      widths_.push_back(needed);
    }
  }

  static std::string cell(const Leaf& leaf) {
    if (special_meaning(leaf) != nullptr) return special_meaning(leaf);
    const bool is_scaled = leaf.unit != nullptr && !leaf.unit->is_plain();
    if (is_scaled || leaf.kind == LeafKind::real) {
      const std::optional<double> real = real_value(leaf);
      return real ? fmt::format("{:.3f}", *real) : "-";
    }
    return leaf.unit != nullptr ? raw_text(leaf) : value_text(leaf);
  }

  std::vector<StreamField> fields_;
  FieldPlaces places_;
  const char* key_;
  std::size_t key_width_;
  // The columns that are shown.
  std::vector<Title> titles_;
  std::vector<std::size_t> widths_;
};

}  // namespace

OutputFormat format_named(std::string_view name) {
  if (name == "csv") return OutputFormat::csv;
  return name == "jsonl" ? OutputFormat::jsonl : OutputFormat::text;
}

std::unique_ptr<SampleWriter> SampleWriter::make(OutputFormat format, std::string message,
                                                 std::vector<StreamField> fields, std::size_t width,
                                                 SampleKey key) {
  switch (format) {
    case OutputFormat::csv: return std::make_unique<CsvWriter>(std::move(fields), key);
    case OutputFormat::jsonl:
      return std::make_unique<JsonWriter>(std::move(message), std::move(fields));
    case OutputFormat::text: break;
  }
  return std::make_unique<TableWriter>(std::move(fields), width, key);
}

}  // namespace sbgc::tools
