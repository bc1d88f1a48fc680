#include "command/remark.hpp"

#include "command/help_text.hpp"
#include "command/system.hpp"

namespace sbgc::tools {

std::string message_text(std::string text) {
  if (!text.starts_with("sbgc: ") || !is_terminal(stderr)) return text;
  return wrapped(text, line_width(stderr)) + (text.ends_with('\n') ? "\n" : "");
}

}  // namespace sbgc::tools
