#include "values/field_patterns.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>

#include "command/command_error.hpp"
#include "command/wording.hpp"
#include "values/field_lookup.hpp"

namespace sbgc::tools {

namespace {

bool is_end_of(std::string_view path, std::string_view end) {
  return path.ends_with(end) && path.size() > end.size() &&
         path[path.size() - end.size() - 1] == '.';
}

/// Returns the last names of the paths, and the paths.
std::vector<std::string> known_words(const std::vector<std::string>& paths) {
  std::vector<std::string> words;
  for (const std::string& path : paths) {
    words.push_back(path);
    words.push_back(path.substr(0, path.find_first_of(".[")));
    const std::size_t dot = path.rfind('.');
    if (dot != std::string::npos) words.push_back(path.substr(dot + 1));
  }
  std::ranges::sort(words);
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

template <class Test>
bool choose(const std::vector<std::string>& paths, std::vector<bool>& chosen, const Test& test) {
  bool found = false;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (!test(paths[i])) continue;
    chosen[i] = true;
    found = true;
  }
  return found;
}

/// Returns the paths that a field name of the specification denotes.
std::vector<std::string> paths_named(std::string_view name, const MessageType& message) {
  std::vector<std::string> paths;
  try {
    for (const FoundField& field : find_fields(message.fields(), name)) {
      paths.push_back(steps_text(field.steps));
    }
  } catch (const ValueError&) {
    return {};  // it fits different fields, or lacks an index
  }
  return paths;
}

void apply(std::string_view pattern, const MessageType& message,
           const std::vector<std::string>& paths, std::vector<bool>& chosen) {
  const auto is_glob = [&](const std::string& path) { return matches_glob(pattern, path); };
  const auto is_group = [&](const std::string& path) { return detail::is_in_field(path, pattern); };
  if (choose(paths, chosen, is_glob) || choose(paths, chosen, is_group)) return;
  std::vector<std::string> ends;
  for (const std::string& path : paths) {
    if (is_end_of(path, pattern)) ends.push_back(path);
  }
  if (ends.size() > 1) {
    throw CommandError(fmt::format("the field '{}' is not unique: {}", clipped(pattern),
                                   detail::alternatives(ends, false)),
                       wrong_usage);
  }
  if (ends.empty()) ends = paths_named(pattern, message);
  const auto is_named = [&](const std::string& path) {
    return std::ranges::any_of(
        ends, [&](const std::string& end) { return detail::is_in_field(path, end); });
  };
  if (choose(paths, chosen, is_named)) return;
  throw CommandError(fmt::format("no field matches '{}'{}", clipped(pattern),
                                 detail::did_you_mean(detail::nearest(pattern, known_words(paths)),
                                                      fmt::format("`sbgc describe {}` lists them",
                                                                  message.info->name))),
                     wrong_usage);
}

}  // namespace

bool matches_glob(std::string_view pattern, std::string_view text) {
  // At a mismatch, the last * consumes one more character.
  std::size_t p = 0;
  std::size_t t = 0;
  std::size_t star = std::string_view::npos;
  std::size_t mark = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      mark = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++mark;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<bool> chosen_fields(std::string_view patterns, const MessageType& message,
                                const std::vector<std::string>& paths) {
  std::vector<bool> chosen(paths.size(), patterns.empty());
  while (!patterns.empty()) {
    const std::size_t comma = std::min(patterns.find(','), patterns.size());
    apply(detail::trimmed(patterns.substr(0, comma)), message, paths, chosen);
    patterns.remove_prefix(std::min(comma + 1, patterns.size()));
  }
  return chosen;
}

}  // namespace sbgc::tools
