/// Paging of long texts on a terminal.
#pragma once

#include <string>

namespace sbgc::tools {

/// Prints text. If standard output is a terminal, uses the pager: $PAGER, or `less -FRX` if
/// available.
void print_paged(const std::string& text);

}  // namespace sbgc::tools
