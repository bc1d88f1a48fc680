#include "parameters/vendor_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>

#include <expat.h>
#include <fmt/format.h>

namespace sbgc::tools {

namespace {

// Each limit is at least three times what a file with five profiles needs.
constexpr std::size_t longest_text = std::size_t{1} << 20U;
constexpr std::size_t longest_name = 64;
constexpr std::size_t deepest_element = 8;
constexpr std::size_t most_values = 20'000;
constexpr std::size_t most_profiles = 5;

constexpr const char* root_element = "saved-configuration";
constexpr const char* common_element = "board-params";
constexpr const char* profile_element = "profile";

/// True for an element of a list: a type of Java, or the name of a class, which has hyphens.
bool is_list_element(std::string_view name) {
  constexpr std::array types{"boolean", "bool",  "byte",   "short", "int",
                             "long",    "float", "double", "char",  "string"};
  return name.find('-') != std::string_view::npos || std::ranges::find(types, name) != types.end();
}

std::string without_space(std::string_view text) {
  constexpr const char* space = " \t\r\n";
  const std::size_t first = text.find_first_not_of(space);
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(space) - first + 1));
}

class VendorFileReader {
 public:
  Result<VendorFile> read(std::string_view text) {
    if (text.size() > longest_text) {
      return ClientError{ErrorCode::bad_file, fmt::format("more than {} bytes", longest_text)};
    }
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser(
        XML_ParserCreate(nullptr), XML_ParserFree);
    parser_ = parser.get();
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(
        parser_,
        [](void* user, const char* name, const char** /*attributes*/) { of(user).open(name); },
        [](void* user, const char* /*name*/) { of(user).close(); });
    XML_SetCharacterDataHandler(parser_, [](void* user, const char* characters, int size) {
      of(user).text_.append(characters, static_cast<std::size_t>(size));
    });
    XML_SetStartDoctypeDeclHandler(
        parser_, [](void* user, const char* /*name*/, const char* /*system*/, const char* /*id*/,
                    int /*internal*/) { of(user).fail("a document type is not allowed"); });
    const auto status = XML_Parse(parser_, text.data(), static_cast<int>(text.size()), XML_TRUE);
    if (problem_.empty() && status != XML_STATUS_OK) {
      fail(XML_ErrorString(XML_GetErrorCode(parser_)));
    }
    if (problem_.empty()) finish();
    if (!problem_.empty()) return ClientError{ErrorCode::bad_file, problem_};
    return std::move(file_);
  }

 private:
  struct Level {
    std::string name;
    bool has_children = false;
  };

  static VendorFileReader& of(void* user) { return *static_cast<VendorFileReader*>(user); }

  void open(std::string_view name) {
    if (!problem_.empty()) return;
    if (name.size() > longest_name) return fail("a name is too long");
    if (levels_.size() == deepest_element) return fail("the elements are nested too deeply");
    if (levels_.empty() && name != root_element) {
      return fail(fmt::format("expected <{}>, the root of such files", root_element));
    }
    if (!without_space(text_).empty()) return fail("text beside an element");
    text_.clear();
    if (levels_.size() == 1) open_section(name);
    if (!levels_.empty()) levels_.back().has_children = true;
    levels_.push_back({std::string(name)});
  }

  void open_section(std::string_view name) {
    section_ = nullptr;
    places_.clear();
    if (name == common_element) {
      if (std::exchange(has_common_, true)) return fail("a second <board-params>");
      section_ = &file_.common;
    } else if (name == profile_element) {
      if (file_.profiles.size() == most_profiles) return fail("more than 5 profiles");
      section_ = &file_.profiles.emplace_back();
    }
  }

  void close() {
    if (!problem_.empty()) return;
    const bool is_value = !levels_.back().has_children;
    const std::string text = without_space(text_);
    text_.clear();
    if (!is_value && !text.empty()) return fail("text beside an element");
    if (is_value && levels_.size() == 2 && section_ == nullptr) {
      facts_[levels_.back().name] = text;
    } else if (is_value && levels_.size() > 2 && section_ != nullptr) {
      add(text);
    }
    levels_.pop_back();
  }

  void add(const std::string& text) {
    if (++values_ > most_values) return fail(fmt::format("more than {} values", most_values));
    std::string name;
    for (std::size_t i = 2; i < levels_.size(); ++i) {
      if (!is_list_element(levels_[i].name)) name += (name.empty() ? "" : "/") + levels_[i].name;
    }
    if (name.empty()) return fail("a value without a name");
    const auto [place, is_new] = places_.try_emplace(name, section_->size());
    if (is_new) section_->push_back({name, {}});
    (*section_)[place->second].values.push_back(text);
  }

  void finish() {
    BoardIdentity& board = file_.board;
    if (!has_common_ || file_.profiles.empty()) {
      problem_ = fmt::format("it lacks <{}> or <{}>", common_element, profile_element);
    } else if (!read_fact("boardVer", board.info.board_ver) ||
               !read_fact("firmwareVer", board.info.firmware_ver)) {
      problem_ = "boardVer and firmwareVer do not say of which board and firmware it is";
    }
  }

  template <class Version>
  bool read_fact(const char* name, Version& out) {
    const std::string& text = facts_[name];
    typename Version::raw_type raw{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), raw);
    out = Version(raw);
    return error == std::errc() && end == text.data() + text.size() && raw != 0;
  }

  void fail(std::string_view reason) {
    if (!problem_.empty()) return;
    problem_ = fmt::format("{} (line {})", reason, XML_GetCurrentLineNumber(parser_));
    XML_StopParser(parser_, XML_FALSE);
  }

  XML_Parser parser_{};
  std::vector<Level> levels_{};
  std::string text_{};
  SavedSection* section_{};
  std::map<std::string, std::size_t> places_{};  ///< of the names in the section
  std::map<std::string, std::string> facts_{};
  bool has_common_ = false;
  std::size_t values_ = 0;
  VendorFile file_{};
  std::string problem_{};
};

}  // namespace

Result<VendorFile> parse_vendor_file(std::string_view text) {
  return VendorFileReader().read(text);
}

}  // namespace sbgc::tools
