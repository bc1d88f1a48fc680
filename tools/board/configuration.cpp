#include "board/configuration.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/io/internal/own_file.hpp>

#include "command/command_error.hpp"

namespace sbgc::tools {

namespace {

constexpr std::size_t largest_configuration = std::size_t{1} << 16U;
constexpr std::size_t most_attempts = 100;

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
  const Result<std::string> text = detail::read_text_file(path, largest_configuration);
  if (!text) throw CommandError(text.error().message);
  return gimbals_in(*text);
}

NamedGimbal read_gimbal(SectionReader& section, const std::string& name,
                        const std::filesystem::path& folder) {
  NamedGimbal gimbal{.name = name};
  gimbal.port = section.required_text("port", "port = \"/dev/ttyUSB0\"");
  gimbal.timeout = section.duration("timeout");
  if (const auto attempts = section.count("attempts", 1, most_attempts)) {
    gimbal.attempts = static_cast<unsigned>(*attempts);
  }
  gimbal.attempt_timeout = section.duration("attempt-time");
  const std::string file = section.text("password-file").value_or("");
  gimbal.password_file = file.empty() || file == "-" ? file : (folder / file).string();
  return gimbal;
}

std::vector<NamedGimbal> gimbals_in(const std::string& text) {
  const std::filesystem::path file = configuration_file();
  const ConfigurationText configuration(text, file.string());
  std::vector<NamedGimbal> gimbals;
  for (const ConfigurationSection& section : configuration.sections()) {
    if (section.path.empty() && section.keys.empty()) continue;
    if (section.path.size() != 2 || section.path.front() != "gimbal") {
      const bool has_keys = section.path.empty();
      configuration.reject(
          has_keys ? section.keys.front().place : section.place,
          fmt::format("{} is not in a section [gimbal.NAME]",
                      has_keys ? '\'' + section.keys.front().name + '\'' : section.name()));
    }
    SectionReader reader(configuration, section);
    gimbals.push_back(read_gimbal(reader, section.path.back(), file.parent_path()));
    reader.finish();
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
