/// The values of parameters as text, to compare them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <sbgc/meta/all.hpp>
#include <sbgc/text/leaves.hpp>

namespace sbgc::detail {

/// One value.
struct LeafText {
  std::string path;
  std::string raw;
  std::string meaning;  ///< "-30 deg", "FOLLOW_MODE_FC", or ""
};

/// Collects the values that are parameters; bytes without a meaning as numbers one by one.
class LeafTexts {
 public:
  void operator()(const Leaf& leaf);

  std::vector<LeafText> take() { return std::move(texts_); }

 private:
  std::vector<LeafText> texts_;
};

/// The values of a message that are parameters.
template <class M>
std::vector<LeafText> leaf_texts(const M& message) {
  LeafTexts texts;
  for_each_leaf(message, texts);
  return texts.take();
}

}  // namespace sbgc::detail
