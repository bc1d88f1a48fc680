/// The files in which the vendor's program saves parameters: XML, usually named .profile.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/result.hpp>

namespace sbgc::tools {

/// The contents of a file under one name: one value, or the elements of a list in file order.
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

/// Processes the elements and texts in file order. After the first problem, it ignores everything.
class VendorElements {
 public:
  void open(std::string_view name);
  void text(std::string_view characters) { text_ += characters; }
  void close();
  /// Records a problem, unless there is one already.
  void fail(std::string_view reason);
  bool has_failed() const { return !problem_.empty(); }
  /// Returns the contents. Errors: `bad_file`.
  Result<VendorFile> finish();

 private:
  struct Level {
    std::string name;
    bool has_children = false;
  };

  void open_section(std::string_view name);
  void add(const std::string& text);
  void check();
  template <class Version>
  bool read_fact(const char* name, Version& out);

  std::vector<Level> levels_{};
  std::string text_{};
  SavedSection* section_{};
  std::map<std::string, std::size_t> places_{};  // of the names in the section
  std::map<std::string, std::string> facts_{};
  bool has_common_ = false;
  std::size_t values_ = 0;
  VendorFile file_{};
  std::string problem_{};
};

/// Parses the XML. Document types, and thus entities, are rejected; size, depth, the length of a
/// name and the number of values are limited. Fails with ErrorCode::bad_file.
Result<VendorFile> parse_vendor_file(std::string_view text);

}  // namespace sbgc::tools
