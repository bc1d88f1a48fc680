#include "serving/share.hpp"

#include <sbgc/internal/parse_number.hpp>

namespace sbgc::serving {

std::optional<double> read_share(std::string_view text, double least, double most) {
  const bool is_percent = text.ends_with('%');
  if (is_percent) text.remove_suffix(1);
  const auto number = sbgc::detail::parse_number<double>(text);
  if (!number || (least >= 0 && text.front() == '-')) return {};
  const double share = is_percent ? *number / 100 : *number;
  return share >= least && share <= most ? std::optional(share) : std::nullopt;  // NaN is neither
}

}  // namespace sbgc::serving
