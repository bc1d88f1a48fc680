/// Shares as people write them.
#pragma once

#include <optional>
#include <string_view>

namespace sbgc::serving {

/// Reads "0.01" or "1%". Returns nothing for other text or a share outside the range.
std::optional<double> read_share(std::string_view text, double least, double most);

}  // namespace sbgc::serving
