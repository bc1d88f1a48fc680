#include "share/page_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace sbgc::tools {

namespace {

namespace fs = std::filesystem;

constexpr const char* first_page = "setup.html";

constexpr std::array<std::pair<const char*, const char*>, 8> types{{
    {".css", "text/css"},
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript"},
    {".json", "application/json"},
    {".svg", "image/svg+xml"},
    {".txt", "text/plain; charset=utf-8"},
    {".wasm", "application/wasm"},
    {".webmanifest", "application/manifest+json"},
}};

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || c == '.' || c == '/';
}

}  // namespace

std::optional<PageFile> page_file(const std::string& folder, std::string_view target) {
  std::string name(target.substr(0, std::min(target.find('?'), target.size())));
  if (name.ends_with('/')) name += first_page;
  // No name of the site has other characters, or a part that begins with a dot.
  if (!name.starts_with('/') || !std::ranges::all_of(name, is_plain)) return std::nullopt;
  if (name.find("/.") != std::string::npos) return std::nullopt;
  const fs::path path = fs::path(folder) / name.substr(1);
  const auto* const type = std::ranges::find(
      types, path.extension().string(), [](const auto& one) { return std::string(one.first); });
  std::error_code error;
  if (type == types.end() || !fs::is_regular_file(path, error)) return std::nullopt;
  return PageFile{path.string(), type->second};
}

bool is_loopback_host(std::string_view host) {
  constexpr std::array names{"127.0.0.1", "localhost", "[::1]"};
  return std::ranges::any_of(names, [&](std::string_view name) {
    return host == name || (host.starts_with(name) && host[name.size()] == ':');
  });
}

std::string page_folder_problem(const std::string& folder) {
  std::error_code error;
  if (fs::is_regular_file(fs::path(folder) / first_page, error)) return "";
  return fmt::format("{} has no {}; `./dev docs` makes such a folder, a release has it", folder,
                     first_page);
}

}  // namespace sbgc::tools
