#include "values/field_lookup.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>

#include "values/search_words.hpp"

namespace sbgc::tools {

namespace {

using Way = std::vector<WayStep>;

void walk(const std::vector<FieldType>& members, Way& way,
          const std::function<void(const Way&, const FieldType&)>& use);

void walk_into(const FieldType& type, Way& way,
               const std::function<void(const Way&, const FieldType&)>& use) {
  use(way, type);
  if (type.shape == FieldShape::group) return walk(type.members, way, use);
  if (!type.has_elements()) return;
  way.push_back({nullptr, &type});
  walk_into(type.members.front(), way, use);
  way.pop_back();
}

void walk(const std::vector<FieldType>& members, Way& way,
          const std::function<void(const Way&, const FieldType&)>& use) {
  for (const FieldType& member : members) {
    way.push_back({&member, nullptr});
    walk_into(member, way, use);
    way.pop_back();
  }
}

/// A name as the user wrote it: words and indices, in order.
struct Token {
  std::string word{};
  std::optional<std::size_t> index{};
};

/// Splits "params[3].param_id". Throws ValueError.
std::vector<Token> tokens_of(std::string_view name) {
  const std::string whole(name);
  const auto fail = [&] {
    throw ValueError(
        fmt::format("'{}' is not the name of a field; names are written as in "
                    "axes.pitch.angle or params[3].param_id",
                    whole));
  };
  std::vector<Token> tokens;
  while (!name.empty()) {
    if (name.front() == '[') {
      const std::size_t close = name.find(']');
      if (close == std::string_view::npos) fail();
      const auto index = detail::parse_number<std::size_t>(name.substr(1, close - 1));
      if (!index) fail();
      tokens.push_back({.index = index});
      name.remove_prefix(close + 1);
    } else {
      const std::size_t size = std::min(name.find_first_of(".["), name.size());
      if (size == 0) fail();
      tokens.push_back({.word = std::string(name.substr(0, size))});
      name.remove_prefix(size);
    }
    if (name.empty() || name.front() == '[') continue;
    if (name.front() != '.' || name.size() == 1) fail();
    name.remove_prefix(1);
  }
  if (tokens.empty()) fail();
  return tokens;
}

/// The element selected at each step of a path; nothing where all are meant.
using Choice = std::vector<std::optional<std::size_t>>;

std::optional<std::size_t> axis_of(const FieldType& axes, std::string_view word) {
  for (std::size_t i = 0; i < axes.axes.size(); ++i) {
    if (means_same(word, axes.axes[i])) return i;
  }
  return std::nullopt;
}

/// Matches the tokens with the end of a path, starting with the last one. `is_whole` becomes true
/// if the first token is the first member.
bool matches(const std::vector<Token>& tokens, const Way& way, Choice& choice, bool& is_whole) {
  choice.assign(way.size(), std::nullopt);
  std::size_t step = way.size();
  for (std::size_t left = tokens.size(); left != 0;) {
    if (step == 0) return false;
    const Token& token = tokens[left - 1];
    const WayStep& at = way[--step];
    if (at.member != nullptr) {
      if (token.index || !detail::is_same_word(token.word, at.member->name)) return false;
      --left;
    } else if (at.elements->shape == FieldShape::list) {
      if (!token.index) {
        if (step + 1 == way.size()) return false;  // the list itself is meant
        continue;
      }
      choice[step] = token.index;
      --left;
    } else {
      const auto axis = token.index ? std::nullopt : axis_of(*at.elements, token.word);
      if (axis) {
        choice[step] = axis;
        --left;
      } else if (step + 1 == way.size()) {
        return false;  // the axes themselves are meant
      }
    }
  }
  is_whole = step == 0;
  // An element alone, such as "pitch" or "[0]", could belong to anything.
  const bool is_of_list =
      way[step].elements != nullptr && way[step].elements->shape == FieldShape::list;
  return !is_of_list && (way[step].member != nullptr || tokens.size() > 1);
}

/// Matches "P_PITCH" or "PITCH_P" with the name P in the specification and an element of axes
/// around or in it.
bool matches_with_axis(std::string_view name, std::string_view spec_name, const Way& way,
                       Choice& choice) {
  if (name.size() < spec_name.size() + 2) return false;
  const std::size_t gap = spec_name.size();
  const std::size_t last = name.size() - gap;
  const bool is_first = detail::is_same_word(name.substr(0, gap), spec_name) && name[gap] == '_';
  const bool is_last = detail::is_same_word(name.substr(last), spec_name) && name[last - 1] == '_';
  if (!is_first && !is_last) return false;
  const std::string_view axis = is_first ? name.substr(gap + 1) : name.substr(0, last - 1);
  for (std::size_t i = way.size(); i-- != 0;) {
    if (way[i].member != nullptr || way[i].elements->shape != FieldShape::axes) continue;
    choice[i] = axis_of(*way[i].elements, axis);
    return choice[i].has_value();
  }
  return false;
}

/// Matches the name in the specification, where {AXIS} and {1..5} stand for the element.
bool matches_specification(std::string_view name, const Way& way, Choice& choice) {
  const FieldType* member = nullptr;
  std::size_t last = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (way[i].member == nullptr) continue;
    member = way[i].member;
    last = i;
  }
  if (member == nullptr || member->info == nullptr) return false;
  const std::string_view pattern = member->info->spec_name;
  if (pattern.empty()) return false;
  choice.assign(way.size(), std::nullopt);
  const std::size_t open = pattern.find('{');
  if (open == std::string_view::npos) {
    if (last + 1 == way.size() && detail::is_same_word(name, pattern)) return true;
    return matches_with_axis(name, pattern, way, choice);
  }
  const std::string_view head = pattern.substr(0, open);
  const std::string_view tail = pattern.substr(pattern.find('}') + 1);
  if (name.size() <= head.size() + tail.size()) return false;
  const std::string_view middle = name.substr(head.size(), name.size() - head.size() - tail.size());
  if (!detail::is_same_word(name.substr(0, head.size()), head)) return false;
  if (!detail::is_same_word(name.substr(name.size() - tail.size()), tail)) return false;
  for (std::size_t i = way.size(); i-- != 0;) {
    if (way[i].member != nullptr) continue;
    if (way[i].elements->shape == FieldShape::axes) {
      choice[i] = axis_of(*way[i].elements, middle);
    } else {
      const auto number = detail::parse_number<std::size_t>(middle);
      std::size_t first = 0;
      std::from_chars(pattern.data() + open + 1, pattern.data() + pattern.size(), first);
      const bool fits = number && *number >= first && *number - first < way[i].elements->count;
      if (fits) choice[i] = *number - first;
    }
    return choice[i].has_value() && i + 1 >= last;
  }
  return false;
}

/// A field that a name denotes.
struct Match {
  std::size_t source = 0;
  Way way{};
  Choice choice{};
  const FieldType* type = nullptr;
};

/// Returns the path with every open axis spelled out.
void spell_out(const Match& match, std::size_t step, FieldSteps& steps,
               std::vector<FoundField>& result) {
  if (step == match.way.size()) {
    result.push_back({steps, match.type});
    return;
  }
  const WayStep& at = match.way[step];
  const auto go_on = [&](auto next) {
    steps.emplace_back(std::move(next));
    spell_out(match, step + 1, steps, result);
    steps.pop_back();
  };
  if (at.member != nullptr) return go_on(std::string(at.member->name));
  const auto chosen = match.choice[step];
  if (at.elements->shape == FieldShape::list) return go_on(chosen.value_or(0));
  if (chosen) return go_on(std::string(at.elements->axes[*chosen]));
  for (const char* const axis : at.elements->axes) go_on(std::string(axis));
}

std::vector<FoundField> fields_at(const Match& match) {
  std::string path;
  for (std::size_t i = 0; i < match.way.size(); ++i) {
    const FieldType* const list = match.way[i].elements;
    if (list == nullptr || list->shape != FieldShape::list) continue;
    const std::size_t most = list->count;
    if (!match.choice[i]) {
      const Way way(match.way.begin(), match.way.begin() + static_cast<std::ptrdiff_t>(i));
      throw ValueError(fmt::format("{} is a list; name the element, such as {}[0]{}", way_text(way),
                                   way_text(way), i + 1 == match.way.size() ? "" : ".…"));
    }
    if (*match.choice[i] >= most) {
      const Way way(match.way.begin(), match.way.begin() + static_cast<std::ptrdiff_t>(i));
      throw ValueError(fmt::format("{} has {}{} elements, counted from 0; there is no [{}]",
                                   way_text(way), list->has_count ? "" : "at most ", most,
                                   *match.choice[i]));
    }
  }
  std::vector<FoundField> result;
  FieldSteps steps;
  spell_out(match, 0, steps, result);
  return result;
}

std::string text_of(const Match& match, const std::vector<FieldSource>& sources) {
  const std::string path = way_text(match.way);
  return sources.size() > 1 ? sources[match.source].name + "." + path : path;
}

/// Returns the fields that the name denotes. More than one means that it is ambiguous.
std::vector<Match> matches_of(const std::vector<FieldSource>& sources, std::string_view name,
                              const std::vector<Token>& tokens) {
  std::vector<Match> whole;
  std::vector<Match> ends;
  std::vector<Match> specified;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for_each_field(*sources[i].members, [&](const Way& way, const FieldType& type) {
      Match match{i, way, {}, &type};
      bool is_whole = false;
      if (matches(tokens, way, match.choice, is_whole)) {
        (is_whole ? whole : ends).push_back(match);
      } else if (matches_specification(name, way, match.choice)) {
        specified.push_back(match);
      }
    });
  }
  if (!whole.empty()) return whole;
  return ends.empty() ? specified : ends;
}

/// The same; the axis may also be on the other side: pitch.lpf_freq for lpf_freq.pitch.
std::vector<Match> matches_of(const std::vector<FieldSource>& sources, std::string_view name) {
  std::vector<Token> tokens = tokens_of(name);
  std::vector<Match> found = matches_of(sources, name, tokens);
  if (!found.empty() || tokens.size() != 2) return found;
  std::swap(tokens[0], tokens[1]);
  return matches_of(sources, name, tokens);
}

}  // namespace

std::string steps_text(const FieldSteps& steps) {
  std::string result;
  for (const PathStep& step : steps) {
    if (const auto* const name = std::get_if<std::string>(&step)) {
      result += (result.empty() ? "" : ".") + *name;
    } else {
      result += fmt::format("[{}]", std::get<std::size_t>(step));
    }
  }
  return result;
}

void for_each_field(const std::vector<FieldType>& members,
                    const std::function<void(const Way&, const FieldType&)>& use) {
  Way way;
  walk(members, way, use);
}

std::string way_text(const Way& way) {
  std::string result;
  for (const WayStep& step : way) {
    if (step.member != nullptr) {
      result += (result.empty() ? "" : ".") + std::string(step.member->name);
    } else if (step.elements->shape == FieldShape::list) {
      result += "[]";
    } else {
      result += fmt::format(".{}", fmt::join(step.elements->axes, "|"));
    }
  }
  return result;
}

SourcedFields find_fields(const std::vector<FieldSource>& sources, std::string_view name) {
  // The name of a source may come first.
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::size_t dot = name.find('.');
    if (dot == std::string_view::npos ||
        !detail::is_same_word(name.substr(0, dot), sources[i].name)) {
      continue;
    }
    const SourcedFields found = find_fields({sources[i]}, name.substr(dot + 1));
    return {i, found.fields};
  }
  const std::vector<Match> found = matches_of(sources, name);
  if (found.empty()) return {};
  if (found.size() == 1) return {found.front().source, fields_at(found.front())};
  std::vector<std::string> candidates;
  candidates.reserve(found.size());
  for (const Match& match : found) candidates.push_back(text_of(match, sources));
  throw ValueError(fmt::format("'{}' can mean {}; write more of the path", name,
                               detail::alternatives(candidates, false)));
}

std::vector<FoundField> find_fields(const std::vector<FieldType>& members, std::string_view name) {
  return find_fields(std::vector<FieldSource>{{"", &members}}, name).fields;
}

std::vector<std::string> similar_fields(const std::vector<FieldSource>& sources,
                                        std::string_view name) {
  std::vector<std::string> known;
  const auto add = [&](const std::string& text) {
    const bool is_axis = text.size() == 1 || text == "roll" || text == "pitch" || text == "yaw";
    if (!is_axis && std::ranges::find(known, text) == known.end()) known.push_back(text);
  };
  for (const FieldSource& source : sources) {
    for (const std::string& path : field_paths(*source.members)) {
      for (std::size_t at = 0; at != std::string::npos;) {
        add(path.substr(at));
        at = path.find('.', at);
        if (at != std::string::npos) ++at;
      }
    }
  }
  return detail::nearest(detail::lower_case(name), known);
}

std::vector<std::string> field_paths(const std::vector<FieldType>& members) {
  std::vector<std::string> paths;
  for_each_field(members, [&](const Way& way, const FieldType& type) {
    const bool has_parts =
        type.shape == FieldShape::group || type.shape == FieldShape::axes ||
        (type.shape == FieldShape::list && type.members.front().shape == FieldShape::group);
    const bool is_element =
        way.back().elements != nullptr && way.back().elements->shape == FieldShape::list;
    if (has_parts || is_element || type.is_counter || type.is_tail()) return;
    const Match match{0, way, Choice(way.size()), &type};
    std::vector<FoundField> found;
    FieldSteps steps;
    spell_out(match, 0, steps, found);
    for (const FoundField& field : found) paths.push_back(steps_text(field.steps));
  });
  return paths;
}

}  // namespace sbgc::tools
