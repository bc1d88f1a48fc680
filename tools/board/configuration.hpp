/// The configuration file of the command, in TOML:
///
///     [gimbal.front]
///     port = "/dev/ttyUSB0"
///     timeout = 30          # optional, as the options of the command line
///     attempts = 5
///     attempt-time = 0.5
///     password-file = "front.password"   # of mode 0600; relative to this file; "-" asks
///
/// Its path is $SBGC_CONFIG, else $XDG_CONFIG_HOME/sbgc/config.toml, else
/// ~/.config/sbgc/config.toml.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "values/configuration_text.hpp"

namespace sbgc::tools {

struct NamedGimbal {
  std::string name{};
  std::string port{};
  std::optional<std::chrono::milliseconds> timeout{};
  std::optional<unsigned> attempts{};
  std::optional<std::chrono::milliseconds> attempt_timeout{};
  std::string password_file{};  ///< "-" asks for the password; "" if there is none
};

std::filesystem::path configuration_file();

/// Returns the gimbals of the configuration file; none if there is no file. Throws CommandError if
/// the file cannot be read or is invalid.
std::vector<NamedGimbal> named_gimbals();

/// Reads the keys of [gimbal.NAME]. A password file is relative to this folder. Callers may read
/// further keys before SectionReader::finish().
NamedGimbal read_gimbal(SectionReader& section, const std::string& name,
                        const std::filesystem::path& folder);

/// Returns the gimbals in the text of a configuration file. Throws CommandError if it is invalid.
std::vector<NamedGimbal> gimbals_in(const std::string& text);

/// Returns the gimbal with this name. Throws CommandError, with suggestions, if there is none.
NamedGimbal find_gimbal(const std::string& name);

}  // namespace sbgc::tools
