/// Options of many commands: how to reach the gimbal, and the confirmation of what moves a camera
/// or writes to a board.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace sbgc::tools {

/// The connection to the gimbal. Options that the command line omits come from the configuration
/// file, if it names the gimbal.
struct GimbalOptions {
  std::string port{};  ///< an address for sbgc::io::open(), or ""
  std::string name{};  ///< in the configuration file, or ""
  std::optional<std::chrono::milliseconds> timeout{};
  std::optional<unsigned> attempts{};  ///< of a request that may be repeated
  std::optional<std::chrono::milliseconds> attempt_timeout{};
  std::string password_file{};  ///< for the port; "-" asks for the password, "" for none
  std::string capture{};        ///< file to record the traffic in, or ""
  bool verbose = false;
  /// Set when a capture that is written or replayed lacks a part; all copies share it.
  std::shared_ptr<std::atomic<bool>> is_incomplete = std::make_shared<std::atomic<bool>>(false);
};

/// Checks an option or argument that names a gimbal: nothing would stand for any gimbal.
std::string why_not_empty(const std::string& value);

/// Returns the options that name the same gimbal on another command line: " -p ADDRESS".
std::string words_of(const GimbalOptions& options);

/// The heading of the options in the help.
inline constexpr const char* gimbal_group = "Gimbal";

/// Adds the options to a subcommand, or to `sbgc` itself.
void add_gimbal_options(CLI::App& command, GimbalOptions& options);

struct Arming {
  bool yes = false;  ///< --yes
};

/// Adds --yes to a command. Its remarks wait for no reader.
void add_arming(CLI::App& command, Arming& arming);

/// Says what will happen, in sentences, and asks the user unless --yes was given. Throws
/// CommandError if the user does not agree, or cannot be asked because there is no terminal. What
/// can fail without the user's consent is done before.
void arm(const Arming& arming, const std::string& what_will_happen);

/// Asks the user, who is at a terminal. Anything but a yes is a no.
bool agrees(const std::string& question);

}  // namespace sbgc::tools
