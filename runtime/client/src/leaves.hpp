/// Parameter values as text, for comparison.
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
  std::string meaning;  ///< for example "-30 deg" or "FOLLOW_MODE_FC"; may be ""
};

/// Collects the values that are parameters. Bytes without a meaning become separate numbers.
class LeafTexts {
 public:
  void operator()(const Leaf& leaf);

  std::vector<LeafText> take() { return std::move(texts_); }

 private:
  std::vector<LeafText> texts_;
};

/// Returns the values of a message that are parameters.
template <class M>
std::vector<LeafText> leaf_texts(const M& message) {
  LeafTexts texts;
  for_each_leaf(message, texts);
  return texts.take();
}

}  // namespace sbgc::detail
