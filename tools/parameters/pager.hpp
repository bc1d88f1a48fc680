/// Long texts on a terminal.
#pragma once

#include <string>

namespace sbgc::tools {

/// Prints text. If standard output is a terminal, with the pager: $PAGER, else `less -FRX` if there
/// is one.
void print_paged(const std::string& text);

}  // namespace sbgc::tools
