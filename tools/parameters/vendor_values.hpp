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

/// Names in the file that are not taken, and why.
struct LeftOut {
  std::string reason{};
  std::vector<std::string> names{};
};

/// Parameters with the values of a file.
struct VendorValues {
  /// The sets of which the file holds values; these are general ones, or of a profile of the file.
  ParameterSet parameters{};
  /// The fields that it holds, by message and path.
  std::vector<std::pair<std::string, std::string>> fields{};
  std::vector<LeftOut> left_out{};
};

/// Puts the values of the file into `present`, the parameters of a board. The profile of a file
/// that holds only one becomes the profile `target`, from 0; otherwise, all five do. What all
/// profiles have in common goes to all. Errors: `bad_file` if a board cannot hold a value.
Result<VendorValues> vendor_values(const VendorFile& file, const ParameterSet& present,
                                   std::uint8_t target);

/// Returns parameters of which all are 0, as a board with these versions has them.
ParameterSet empty_parameters(const Availability& versions);

/// For people: a line for each reason; "" if everything is taken.
std::string left_out_text(const VendorValues& values);

}  // namespace sbgc::tools
