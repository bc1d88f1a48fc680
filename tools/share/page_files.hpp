/// The files of a web site, for a server.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sbgc::tools {

/// A file, and what it is for a browser.
struct PageFile {
  std::string path{};
  const char* type = "";
};

/// Returns the file that the target of a request names, such as "/setup.html?x=1"; nothing if the
/// folder has none. Hidden files, and files outside the folder, are none.
std::optional<PageFile> page_file(const std::string& folder, std::string_view target);

/// True if a request with this host comes from a page of this machine: a name of another machine
/// can lead here as well.
bool is_loopback_host(std::string_view host);

/// Returns what is wrong with a folder of pages; "" if nothing is.
std::string page_folder_problem(const std::string& folder);

}  // namespace sbgc::tools
