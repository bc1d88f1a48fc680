#include "leaves.hpp"

namespace sbgc::detail {

void LeafTexts::operator()(const Leaf& leaf) {
  const FieldRole role = leaf.field.role;
  if (role == FieldRole::copy || role == FieldRole::state) return;
  if (leaf.kind == LeafKind::counter) return;
  if (leaf.kind != LeafKind::bytes) {
    texts_.push_back({to_string(leaf.path), raw_text(leaf), meaning_text(leaf)});
    return;
  }
  for (std::size_t i = 0; i < leaf.bytes.size(); ++i) {
    texts_.push_back({to_string(FieldPath{&leaf.path, "", i}), std::to_string(leaf.bytes[i]), ""});
  }
}

}  // namespace sbgc::detail
