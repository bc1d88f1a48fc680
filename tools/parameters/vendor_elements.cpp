#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <sbgc/internal/parse_number.hpp>

#include "parameters/vendor_file.hpp"

namespace sbgc::tools {

namespace {

// Each limit is at least three times the need of a file with five profiles.
constexpr std::size_t longest_name = 64;
constexpr std::size_t deepest_element = 8;
constexpr std::size_t most_values = 20'000;
constexpr std::size_t most_profiles = 5;

constexpr const char* root_element = "saved-configuration";
constexpr const char* common_element = "board-params";
constexpr const char* profile_element = "profile";

/// True for an element of a list: a Java type, or the name of a class, which has hyphens.
bool is_list_element(std::string_view name) {
  constexpr std::array types{"boolean", "bool",  "byte",   "short", "int",
                             "long",    "float", "double", "char",  "string"};
  return name.find('-') != std::string_view::npos ||
         std::find(types.begin(), types.end(), name) != types.end();
}

std::string without_space(std::string_view text) {
  constexpr const char* space = " \t\r\n";
  const std::size_t first = text.find_first_not_of(space);
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(space) - first + 1));
}

}  // namespace

void VendorElements::open(std::string_view name) {
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

void VendorElements::open_section(std::string_view name) {
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

void VendorElements::close() {
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

void VendorElements::add(const std::string& text) {
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

template <class Version>
bool VendorElements::read_fact(const char* name, Version& out) {
  const std::string& text = facts_[name];
  const auto raw = detail::parse_number<typename Version::raw_type>(text);
  out = Version(raw.value_or(0));
  return raw && *raw != 0;
}

void VendorElements::check() {
  BoardIdentity& board = file_.board;
  if (!has_common_ || file_.profiles.empty()) {
    problem_ = fmt::format("it lacks <{}> or <{}>", common_element, profile_element);
  } else if (!read_fact("boardVer", board.info.board_ver) ||
             !read_fact("firmwareVer", board.info.firmware_ver)) {
    problem_ = "boardVer and firmwareVer do not say of which board and firmware it is";
  }
}

void VendorElements::fail(std::string_view reason) {
  if (problem_.empty()) problem_ = reason;
}

Result<VendorFile> VendorElements::finish() {
  if (problem_.empty()) check();
  if (!problem_.empty()) return ClientError{ErrorCode::bad_file, problem_};
  return std::move(file_);
}

}  // namespace sbgc::tools
