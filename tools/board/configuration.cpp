#include "board/configuration.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <sbgc/client/atomic_file.hpp>
#include <sbgc/detail/suggestions.hpp>

#include "command/command_error.hpp"
#include "command/duration.hpp"

namespace sbgc::tools {

namespace {

// The parser handles the whole name of a section for each of its keys, level by level.
constexpr std::size_t largest_configuration = std::size_t{1} << 16U;
constexpr std::ptrdiff_t longest_name = 256;
constexpr std::ptrdiff_t most_levels = 16;

[[noreturn]] void reject(const std::string& reason) {
  throw CommandError(configuration_file().string() + ": " + reason);
}

void check_names(const std::string& text) {
  std::istringstream lines(text);
  std::size_t number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line[first] == '#' || line[first] == ';') continue;
    // The name of a section may have a '='.
    const std::size_t equals = line[first] == '[' ? line.size() : line.find('=');
    const auto name_end = line.begin() + static_cast<std::ptrdiff_t>(std::min(equals, line.size()));
    if (name_end - line.begin() > longest_name) {
      reject(fmt::format("line {}: a name longer than {} bytes", number, longest_name));
    }
    if (std::count(line.begin(), name_end, '.') >= most_levels) {
      reject(fmt::format("line {}: nested deeper than {} levels", number, most_levels));
    }
  }
}

double number(const CLI::ConfigItem& item, double least, double most) {
  const std::string& text = item.inputs.front();
  double value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < least || value > most) {
    reject(fmt::format("'{}' of gimbal '{}' is '{}'; it must be a number from {} to {}", item.name,
                       item.parents.back(), text, least, most));
  }
  return value;
}

std::chrono::milliseconds duration(const CLI::ConfigItem& item) {
  if (const auto parsed = parse_duration(item.inputs.front())) return *parsed;
  reject(fmt::format("'{}' of gimbal '{}' is '{}'; it must be a time, such as 5 or \"500ms\"",
                     item.name, item.parents.back(), item.inputs.front()));
}

void set(NamedGimbal& gimbal, const CLI::ConfigItem& item) {
  if (item.inputs.size() != 1) {
    reject(fmt::format("'{}' of gimbal '{}' must have one value", item.name, gimbal.name));
  }
  if (item.name == "port") {
    gimbal.port = item.inputs.front();
  } else if (item.name == "timeout") {
    gimbal.timeout = duration(item);
  } else if (item.name == "attempts") {
    gimbal.attempts = static_cast<unsigned>(number(item, 1, 100));
  } else if (item.name == "attempt-time") {
    gimbal.attempt_timeout = duration(item);
  } else if (item.name == "password-file") {
    const std::string& file = item.inputs.front();
    gimbal.password_file =
        file == "-" ? file : (configuration_file().parent_path() / file).string();
  } else {
    const std::vector<std::string> known{"port", "timeout", "attempts", "attempt-time",
                                         "password-file"};
    reject(fmt::format("unknown key '{}' of gimbal '{}'; the keys are {}", item.name, gimbal.name,
                       detail::alternatives(known, false, "and")));
  }
}

/// Returns the gimbal that the item belongs to, which it adds if necessary.
NamedGimbal& gimbal_of(const CLI::ConfigItem& item, std::vector<NamedGimbal>& gimbals) {
  if (item.parents.size() != 2 || item.parents.front() != "gimbal") {
    reject(fmt::format("'{}' is not in a section [gimbal.NAME]", item.fullname()));
  }
  const std::string& name = item.parents.back();
  const auto found = std::ranges::find(gimbals, name, &NamedGimbal::name);
  if (found != gimbals.end()) return *found;
  return gimbals.emplace_back(NamedGimbal{.name = name});
}

}  // namespace

std::filesystem::path configuration_file() {
  const auto variable = [](const char* name) -> std::filesystem::path {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
  };
  if (auto file = variable("SBGC_CONFIG"); !file.empty()) return file;
  std::filesystem::path folder = variable("XDG_CONFIG_HOME");
  if (folder.empty()) folder = variable("HOME") / ".config";
  return folder / "sbgc" / "config.toml";
}

std::vector<NamedGimbal> named_gimbals() {
  const std::filesystem::path path = configuration_file();
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return {};
  const Result<std::string> text = detail::read_whole_file(path, largest_configuration);
  if (!text) throw CommandError(text.error().message);
  return gimbals_in(*text);
}

std::vector<NamedGimbal> gimbals_in(const std::string& text) {
  check_names(text);
  std::istringstream input(text);
  std::vector<NamedGimbal> gimbals;
  try {
    for (const CLI::ConfigItem& item : CLI::ConfigTOML().from_config(input)) {
      // The parser marks the beginning and the end of a section.
      if (item.name == "++" || item.name == "--") {
        // A section without keys is a gimbal, too: one without a port.
        const bool is_gimbal = item.parents.size() == 2 && item.parents.front() == "gimbal";
        if (is_gimbal) static_cast<void>(gimbal_of(item, gimbals));
        continue;
      }
      set(gimbal_of(item, gimbals), item);
    }
  } catch (const CLI::Error& error) {
    reject(error.what());
  }
  for (const NamedGimbal& gimbal : gimbals) {
    if (gimbal.port.empty()) reject(fmt::format("gimbal '{}' has no port", gimbal.name));
  }
  return gimbals;
}

NamedGimbal find_gimbal(const std::string& name) {
  std::error_code ignored;
  if (!std::filesystem::exists(configuration_file(), ignored)) {
    throw CommandError(fmt::format("no gimbal '{}': there is no configuration file {}", name,
                                   configuration_file().string()),
                       wrong_usage);
  }
  const std::vector<NamedGimbal> gimbals = named_gimbals();
  const auto found = std::ranges::find(gimbals, name, &NamedGimbal::name);
  if (found != gimbals.end()) return *found;
  std::vector<std::string> names;
  names.reserve(gimbals.size());
  for (const NamedGimbal& gimbal : gimbals) names.push_back(gimbal.name);
  const std::string all = names.empty() ? "none" : detail::alternatives(names, true, "and");
  throw CommandError(
      fmt::format("no gimbal '{}' in {}{}", name, configuration_file().string(),
                  detail::did_you_mean(detail::nearest(name, names), "it names " + all)),
      wrong_usage);
}

}  // namespace sbgc::tools
