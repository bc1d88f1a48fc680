#include "share/web_access.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <random>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace sbgc::tools {

namespace {

/// Calls `use(part)` for each part of a text.
template <class Use>
void for_each_part(std::string_view text, char separator, const Use& use) {
  while (true) {
    const std::size_t end = std::min(text.find(separator), text.size());
    use(text.substr(0, end));
    if (end == text.size()) return;
    text.remove_prefix(end + 1);
  }
}

bool consists_of(std::string_view text, std::string_view characters) {
  return !text.empty() && text.find_first_not_of(characters) == std::string_view::npos;
}

/// True if it has the form that a browser sends: no path, not even a slash, and no capital letters.
bool is_origin(std::string_view text) {
  static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz";
  static constexpr std::string_view scheme = "abcdefghijklmnopqrstuvwxyz0123456789+.-";
  static constexpr std::string_view name = "abcdefghijklmnopqrstuvwxyz0123456789.-";
  static constexpr std::string_view address = "0123456789abcdef:.";
  static constexpr std::string_view digits = "0123456789";
  const std::size_t separator = text.find("://");
  if (separator == std::string_view::npos || !consists_of(text.substr(0, separator), scheme) ||
      letters.find(text.front()) == std::string_view::npos) {
    return false;
  }
  std::string_view host = text.substr(separator + 3);
  const std::size_t end = host.starts_with('[') ? host.find(']') + 1 : host.find(':');
  if (host.starts_with('[') && (end == 0 || !consists_of(host.substr(1, end - 2), address))) {
    return false;
  }
  if (!host.starts_with('[') && !consists_of(host.substr(0, end), name)) return false;
  if (end >= host.size()) return true;
  host.remove_prefix(end + 1);
  return text[text.size() - host.size() - 1] == ':' && host.size() <= 5 &&
         consists_of(host, digits);
}

}  // namespace

bool WebSocketAccess::allows_origin(std::string_view origin) const {
  return std::ranges::find(origins, origin) != origins.end();
}

bool WebSocketAccess::knows_token(std::string_view target, std::string_view protocols) const {
  bool knows = false;
  const auto try_it = [&](std::string_view text, std::string_view name) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    if (text.starts_with(name) && is_same_secret(text.substr(name.size()), token)) knows = true;
  };
  const std::size_t query = std::min(target.find('?'), target.size() - 1);
  for_each_part(target.substr(query + 1), '&',
                [&](std::string_view one) { try_it(one, "token="); });
  for_each_part(protocols, ',', [&](std::string_view one) { try_it(one, "token."); });
  return knows;
}

std::string token_problem(std::string_view token) {
  const bool is_plain = std::ranges::all_of(
      token, [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
  return token.size() >= 8 && is_plain ? "" : "a token has at least 8 letters, digits, - or _";
}

std::string origin_problem(std::string_view origin) {
  if (is_origin(origin)) return "";
  return fmt::format("'{}' is not the origin of a web site, such as http://localhost:8000", origin);
}

std::string make_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) {
    token += fmt::format("{:08x}", static_cast<std::uint32_t>(random()));
  }
  return token;
}

bool is_same_secret(std::string_view one, std::string_view other) {
  // The length is no secret.
  if (one.size() != other.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const auto left = static_cast<unsigned char>(one[i]);
    const auto right = static_cast<unsigned char>(other[i]);
    difference |= static_cast<unsigned>(left ^ right);
  }
  return difference == 0;
}

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
  // No file of the site has other characters, or a part that begins with a dot.
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
