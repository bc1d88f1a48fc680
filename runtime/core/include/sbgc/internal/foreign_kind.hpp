/// Detects the file types of other programs.
#pragma once

#include <algorithm>
#include <string_view>
#include <utility>

namespace sbgc::detail {

/// The result of foreign_kind() for files of the vendor's program.
inline constexpr std::string_view vendor_xml = "XML of the vendor's program";

/// Returns the type of a file that this project does not write, such as "gzip data"; "" for text
/// that may be its own.
inline std::string_view foreign_kind(std::string_view content) noexcept {
  using namespace std::string_view_literals;
  constexpr std::pair<std::string_view, std::string_view> kinds[] = {
      {"PK\x03\x04"sv, "a ZIP archive"},
      {"\x1F\x8B"sv, "gzip data"},
      {"\3757zXZ"sv, "xz data"},
      {"\177ELF"sv, "a program"},
      {"%PDF"sv, "a PDF document"},
      {"\x89PNG"sv, "a PNG picture"},
      {"\xFF\xD8\xFF"sv, "a JPEG picture"},
      {"SQLite format 3"sv, "an SQLite database"},
      {"\x0A\x0D\x0D\x0A"sv, "a capture"},
      {"\xD4\xC3\xB2\xA1"sv, "a capture"},
      {"\xFF\xFE"sv, "text in UTF-16"},
      {"\xFE\xFF"sv, "text in UTF-16"},
      {"-----BEGIN "sv, "a key or certificate"},
      {"<!DOCTYPE html"sv, "an HTML page"},
      {"<!doctype html"sv, "an HTML page"},
      {"<html"sv, "an HTML page"},
      {"<saved-configuration"sv, vendor_xml},
  };
  constexpr std::size_t beginning = 4096;
  std::string_view text = content;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  for (const auto& [start, kind] : kinds) {
    if (content.starts_with(start) || text.starts_with(start)) return kind;
  }
  if (content.substr(0, beginning).find('\0') != std::string_view::npos) return "binary data";
  if (!text.starts_with('<')) return "";
  const bool is_vendors =
      text.substr(0, beginning).find("<saved-configuration") != std::string_view::npos;
  return is_vendors ? vendor_xml : "XML";
}

}  // namespace sbgc::detail
