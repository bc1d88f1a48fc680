#include "value_rows.hpp"

namespace sbgc::tools {

bool PathText::is_of(const FieldPath& path) const {
  const FieldPath* at = &path;
  for (const Level& level : levels_) {
    if (at == nullptr) return level.name == nullptr;
    if (at->name != level.name || at->index != level.index) return false;
    at = at->parent;
  }
  return at == nullptr;
}

std::string_view PathText::of(const FieldPath& path) {
  if (is_of(path)) return text_;
  levels_ = {};
  const FieldPath* at = &path;
  for (Level& level : levels_) {
    if (at == nullptr) break;
    level = {at->name, at->index};
    at = at->parent;
  }
  if (at != nullptr) levels_ = {};  // too deep to recognize
  text_ = to_string(path);
  return text_;
}

void ValueRows::begin(const MessageInfo& info) {
  paths_ = &paths_of_messages_[&info];
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
  if (paths_->size() < size_) paths_->emplace_back();
  row.path = (*paths_)[size_ - 1].of(leaf.path);
  Place place{};
  place.raw = out.size();
  put_raw(out, leaf);
  place.meaning = out.size();
  put_meaning(out, leaf);
  place.end = out.size();
  places_.push_back(place);
}

void ValueRows::end() {
  const char* const text = text_.data();
  for (std::size_t i = 0; i < size_; ++i) {
    const Place& place = places_[i];
    rows_[i].raw = {text + place.raw, place.meaning - place.raw};
    rows_[i].meaning = {text + place.meaning, place.end - place.meaning};
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
