/// Reads the files that the vendor's program saves parameters to: XML, usually named .profile.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/result.hpp>

namespace sbgc::tools {

/// The contents of a file under one name: one value, or the elements of a list in the order of the
/// file.
struct SavedValue {
  std::string name{};  ///< in a section, such as "extIMU/type"
  std::vector<std::string> values{};
};

using SavedSection = std::vector<SavedValue>;

struct VendorFile {
  BoardIdentity board{};  ///< only its versions
  SavedSection common{};  ///< of all profiles
  std::vector<SavedSection> profiles{};
};

/// Parses the XML. Document types, and so entities, are refused; size, depth, the length of a name
/// and the number of values are limited. Fails with ErrorCode::bad_file.
Result<VendorFile> parse_vendor_file(std::string_view text);

}  // namespace sbgc::tools
