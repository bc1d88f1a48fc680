#include "command/remark.hpp"

#include <string_view>

#include "command/system.hpp"
#include "command/terminal_text.hpp"

namespace sbgc::tools {

namespace {

/// Colors what stands between `begin` and `end`, wherever that is in the text.
std::string highlighted(std::string_view text, std::string_view begin, std::string_view end,
                        const Colors& colors) {
  std::string result;
  for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin)) {
    const std::size_t from = at + begin.size();
    const std::size_t to = text.find(end, from);
    if (to == text.npos) break;
    result.append(text.substr(0, from)).append(colors(Color::green, text.substr(from, to - from)));
    text.remove_prefix(to);
    result += text.substr(0, end.size());
    text.remove_prefix(end.size());
  }
  return result.append(text);
}

void remark_colored(std::size_t start, Color color, const std::string& problem,
                    const std::string& advice) {
  const Colors colors(stderr);
  const std::string text = message_text(printable("sbgc: " + problem + '\n'));
  const std::string rest = highlighted(text.substr(start) + printable(advice), "`", "`", colors);
  remark_as_is(colors(Color::bold, colors(color, text.substr(0, start))) +
               highlighted(rest, "did you mean ", "?", colors));
}

}  // namespace

std::string message_text(std::string text) {
  if (!text.starts_with("sbgc: ") || !is_terminal(stderr)) return text;
  return wrapped(text, line_width(stderr)) + (text.ends_with('\n') ? "\n" : "");
}

void remark_failure(const std::string& problem, const std::string& advice) {
  remark_colored(std::string_view("sbgc:").size(), Color::red, problem, advice);
}

void remark_warning(const std::string& problem) {
  remark_colored(std::string_view("sbgc: warning:").size(), Color::yellow, "warning: " + problem,
                 "");
}

}  // namespace sbgc::tools
