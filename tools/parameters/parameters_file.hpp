/// Files with parameters: backups, and files of the vendor's program.
#pragma once

#include <optional>
#include <string>

#include <sbgc/client/backup.hpp>

#include "parameters/board_parameters.hpp"
#include "parameters/vendor_values.hpp"

namespace sbgc::tools {

struct ParametersFile {
  std::string name{};
  Backup backup{};                     ///< of a file of the vendor's program, only the board
  std::optional<VendorFile> vendor{};  ///< of the vendor's program

  /// True if it is for one profile, which the user selects.
  bool is_of_one_profile() const { return vendor && vendor->profiles.size() == 1; }

  /// Returns the values in the file; values that a file of the vendor's program lacks are taken
  /// from `present`. Lists ignored names on standard error. Throws CommandError.
  VendorValues values(const ParameterSet& present, std::uint8_t target);

  bool has_told = false;  ///< the ignored names were listed
};

/// True if the word is the name of such a file: it ends in .json or .profile.
bool is_parameters_file(const std::string& word);

/// Reads a file of either kind. Throws CommandError.
ParametersFile load_parameters_file(const std::string& name);

}  // namespace sbgc::tools
