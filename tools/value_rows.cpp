#include "value_rows.hpp"

namespace sbgc::tools {

void ValueRows::begin() {
  text_.clear();
  places_.clear();
  size_ = 0;
}

void ValueRows::add(const Leaf& leaf, StringOutput& out) {
  if (is_unused(leaf)) return;
  if (size_ == rows_.size()) rows_.emplace_back();
  Row& row = rows_[size_++];
  row.objection.clear();
  row.offset = leaf.offset;
  row.size = leaf.size;
  Place place{};
  place.path = out.size();
  put_path(out, leaf.path);
  place.raw = out.size();
  put_raw(out, leaf);
  place.meaning = out.size();
  put_meaning(out, leaf);
  place.end = out.size();
  places_.push_back(place);
}

void ValueRows::end() {
  const std::string_view text = text_;
  for (std::size_t i = 0; i < size_; ++i) {
    const Place& place = places_[i];
    rows_[i].path = text.substr(place.path, place.raw - place.path);
    rows_[i].raw = text.substr(place.raw, place.meaning - place.raw);
    rows_[i].meaning = text.substr(place.meaning, place.end - place.meaning);
  }
}

void ValueRows::object(const Violation& violation) {
  const std::string path = to_string(violation.path);
  for (std::size_t i = 0; i < size_; ++i) {
    Row& row = rows_[i];
    if (row.path != path) continue;
    if (!row.objection.empty()) row.objection += ", ";
    if (violation.named != nullptr) row.objection += violation.named->name + std::string(" ");
    row.objection += violation_text(violation);
  }
}

}  // namespace sbgc::tools
