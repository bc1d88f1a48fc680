/// The parameters of a board in a file of the vendor's program.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sbgc/client/parameters.hpp>

#include "parameters/vendor_file.hpp"

namespace sbgc::tools {

/// Ignored names of the file, and the reason.
struct LeftOut {
  std::string reason{};
  std::vector<std::string> names{};
};

/// Parameters with the values of a file.
struct VendorValues {
  /// The blocks with values in the file; these are general ones, or of a profile of the file.
  ParameterSet parameters{};
  /// The fields that it contains, by message and path.
  std::vector<std::pair<std::string, std::string>> fields{};
  std::vector<LeftOut> left_out{};
};

/// Stores the values of the file in `present`, the parameters of a board. The profile of a file
/// that holds only one becomes the profile `target`, from 0; otherwise, all five do. Values common
/// to all profiles go to all of them. Errors: `bad_file` if a board cannot hold a value.
Result<VendorValues> vendor_values(const VendorFile& file, const ParameterSet& present,
                                   std::uint8_t target);

/// Returns parameters that are all 0, with the layout for a board with these versions.
ParameterSet empty_parameters(const Availability& versions);

/// Returns a line for each reason, for people; "" if nothing is ignored.
std::string left_out_text(const VendorValues& values);

}  // namespace sbgc::tools
