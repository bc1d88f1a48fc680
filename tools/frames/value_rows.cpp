#include "frames/value_rows.hpp"

#include <sbgc/internal/compiler.hpp>

#include "values/unnamed.hpp"

namespace sbgc::tools {

void PathText::replace(const FieldPath& path) {
  levels_ = {};
  std::size_t size = 0;
  for (const FieldPath* at = &path; at != nullptr; at = at->parent) {
    if (size == most_levels) {  // too deep to recognize
      levels_ = {};
      break;
    }
    levels_[size++] = {at->name, at->index};
  }
  text_ = to_string(path);
}

void ValueRows::assign(const AnyMessage& message, const Availability& allowed,
                       const Availability& meant, Secrets secrets) {
  rows_ = &rows_of_messages_[&message.type()];
  size_ = 0;
  objected_ = 0;
  secrets_ = secrets;
  text_.clear();
  StringOutput out(text_);
  message.for_each_leaf([&](const Leaf& leaf) { add(leaf, out); }, meant);
  out.finish();
  message.validate(allowed, [&](const Violation& violation) { object(violation); });
}

// Most values need nothing of what is not inlined.

SBGC_NOINLINE void ValueRows::put_secret(Leaf leaf, StringOutput& out) const {
  leaf.secrets = secrets_;
  put_raw(out, leaf);
}

SBGC_NOINLINE void ValueRows::note_unnamed(Row& row, const Leaf& leaf) {
  row.objection = unnamed_text(leaf);
}

void ValueRows::add(const Leaf& leaf, StringOutput& out) {
  if (is_unused(leaf)) return;
  if (size_ == rows_->size()) rows_->emplace_back();
  Row& row = (*rows_)[size_++];
  row.path.assign(leaf.path);
  row.objection.clear();
  row.offset = leaf.offset;
  row.size = leaf.size;
  row.raw = out.size();
  if (leaf.field.secret) {
    put_secret(leaf, out);
  } else {
    put_raw(out, leaf);
  }
  row.meaning = out.size();
  put_meaning(out, leaf);
  row.end = out.size();
  if (leaf.names != nullptr || leaf.packed != nullptr) note_unnamed(row, leaf);
}

void ValueRows::object(const Violation& violation) {
  char buffer[128];
  const std::string_view path(buffer, violation.path.write(buffer, sizeof buffer));
  // Most violations are reported in the order of the rows.
  for (std::size_t i = 0; i < size_; ++i) {
    Row& row = (*rows_)[objected_];
    if (row.path.text() == path) {
      const detail::Appender append{row.objection};
      PiecewiseOutput out(append);
      if (!row.objection.empty()) out.put(", ");
      if (violation.named != nullptr) {
        out.put(violation.named->name);
        out.put(' ');
      }
      put_violation(out, violation);
      return out.finish();
    }
    if (++objected_ == size_) objected_ = 0;
  }
}

}  // namespace sbgc::tools
