#include "share/web_socket_access.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <random>
#include <regex>

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
  // As a browser sends it: no path, not even a slash, and no capital letters.
  static const std::regex form(
      R"([a-z][a-z0-9+.-]*://([a-z0-9.-]+|\[[0-9a-f:.]+\])(:[0-9]{1,5})?)");
  const std::string text(origin);
  if (std::regex_match(text, form)) return "";
  return "'" + text + "' is not the origin of a web site, such as http://localhost:8000";
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

}  // namespace sbgc::tools
