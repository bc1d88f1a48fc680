/// Access control for browsers: the origins that may connect over a WebSocket, and the files of a
/// web site.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbgc::tools {

/// A page of any web site can open connections to this machine, so a program must know the token,
/// and a browser must show a page of an allowed origin.
struct WebSocketAccess {
  std::string token{};
  std::vector<std::string> origins{};  ///< such as "http://localhost:8000"
  std::string pages{};  ///< a folder whose files are served as well, to pages that may connect

  bool allows_origin(std::string_view origin) const;
  /// True if the query of the target has "token=TOKEN", or one of the subprotocols, separated by
  /// commas, is "token.TOKEN".
  bool knows_token(std::string_view target, std::string_view protocols) const;
};

/// Returns the problem of a token or an origin that a user chose; "" if it is valid.
std::string token_problem(std::string_view token);
std::string origin_problem(std::string_view origin);

/// Returns a random token of 32 hex digits.
std::string make_token();

/// True if both texts are equal. Takes the same time wherever they differ.
bool is_same_secret(std::string_view one, std::string_view other);

/// A file, and its content type.
struct PageFile {
  std::string path{};
  const char* type = "";
};

/// Returns the file that the target of a request names, such as "/setup.html?x=1"; nothing if the
/// folder has none. Hidden files, and files outside the folder, do not count.
std::optional<PageFile> page_file(const std::string& folder, std::string_view target);

/// True if a request with this host comes from a page of this machine: names of other machines can
/// resolve to this one as well.
bool is_loopback_host(std::string_view host);

/// Returns the problem of a folder of pages; "" if it is valid.
std::string page_folder_problem(const std::string& folder);

}  // namespace sbgc::tools
