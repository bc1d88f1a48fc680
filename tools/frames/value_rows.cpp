#include "frames/value_rows.hpp"

#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>

#include <sbgc/internal/compiler.hpp>

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
  last_ = &messages_[&message.type()];
  size_ = 0;
  objected_ = 0;
  secrets_ = secrets;
  last_->text.swap(last_->text_before);
  last_->text.clear();
  StringOutput out(last_->text);
  message.for_each_leaf([&](const Leaf& leaf) { add(leaf, out); }, meant);
  out.finish();
  last_->rows.resize(size_);  // the texts of others are lost
  message.validate(allowed, [&](const Violation& violation) { object(violation); });
}

// Most values need only the inlined code.

SBGC_NOINLINE void ValueRows::put_secret(Leaf leaf, StringOutput& out) const {
  leaf.secrets = secrets_;
  put_raw(out, leaf);
}

SBGC_NOINLINE void ValueRows::write(Row& row, const Leaf& leaf, StringOutput& out) const {
  row.raw = out.size();
  if (leaf.field.secret) {
    put_secret(leaf, out);
  } else {
    put_raw(out, leaf);
  }
  row.meaning = out.size();
  put_meaning(out, leaf);
  row.end = out.size();
  row.unnamed.clear();
  if (leaf.names != nullptr || leaf.packed != nullptr) row.unnamed = unnamed_text(leaf);
}

void ValueRows::add(const Leaf& leaf, StringOutput& out) {
  if (is_unused(leaf)) return;
  if (size_ == last_->rows.size()) last_->rows.emplace_back();
  Row& row = last_->rows[size_++];
  const bool is_same_path = row.path.assign(leaf.path);
  row.offset = leaf.offset;
  row.size = leaf.size;
  const bool is_integer = leaf.kind == LeafKind::integer && leaf.announced == NumberType::none;
  const Row::Source source{is_integer, leaf.integer, leaf.unit, leaf.assumed_before};
  if (is_same_path && is_integer && source == row.source) {
    const std::size_t moved = out.size() - row.raw;
    out.put({last_->text_before.data() + row.raw, row.end - row.raw});
    row.raw += moved;
    row.meaning += moved;
    row.end += moved;
  } else {
    row.source = source;
    write(row, leaf, out);
  }
  row.objection.clear();
  if (!row.unnamed.empty()) row.objection = row.unnamed;
}

void ValueRows::object(const Violation& violation) {
  // Most violations are reported in the order of the rows.
  for (std::size_t i = 0; i < size_; ++i) {
    Row& row = last_->rows[objected_];
    if (row.path.is_of(violation.path)) {
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

namespace {

/// "; the nearest are CMD_REALTIME_DATA_3 (23) and CMD_REALTIME_DATA_4 (25)".
std::string nearest_text(const EnumInfo& names, std::int64_t value) {
  const ValueInfo* nearest[2] = {nullptr, nullptr};  // below and above
  for (const ValueInfo& one : names.values) {
    const ValueInfo*& best = nearest[one.value > value ? 1 : 0];
    if (best == nullptr || std::abs(one.value - value) < std::abs(best->value - value)) best = &one;
  }
  const auto [below, above] = nearest;
  const auto text = [](const ValueInfo& one) {
    return std::string(one.name) + " (" + std::to_string(one.value) + ')';
  };
  if (below == nullptr && above == nullptr) return "";
  const std::int64_t down = below == nullptr ? INT64_MAX : value - below->value;
  const std::int64_t up = above == nullptr ? INT64_MAX : above->value - value;
  if (up == down) return "; the nearest are " + text(*below) + " and " + text(*above);
  return "; the nearest is " + text(up < down ? *above : *below);
}

bool is_unnamed(const EnumInfo& names, std::int64_t value, bool takes_zero) {
  if (names.is_flags || (takes_zero && value == 0)) return false;
  return detail::value_name(names, value).empty();
}

}  // namespace

std::string unnamed_text(const Leaf& leaf, bool takes_zero) {
  if (leaf.kind != LeafKind::integer || special_meaning(leaf) != nullptr) return "";
  if (leaf.names != nullptr && is_unnamed(*leaf.names, leaf.integer, takes_zero)) {
    return "has no name" + nearest_text(*leaf.names, leaf.integer);
  }
  if (leaf.packed == nullptr) return "";
  const PackedInfo& packed = *leaf.packed;
  if (packed.names != nullptr && !detail::value_name(*packed.names, leaf.integer).empty())
    return "";
  const std::uint64_t raw = detail::low_bits(static_cast<std::uint64_t>(leaf.integer), leaf.size);
  for (const PartInfo& part : packed.parts) {
    if (part.values == nullptr) continue;
    const std::int64_t value = detail::part_value(part, raw);
    if (!is_unnamed(*part.values, value, true)) continue;
    return fmt::format("has no name for {} {}{}", part.name, value,
                       nearest_text(*part.values, value));
  }
  return "";
}

}  // namespace sbgc::tools
