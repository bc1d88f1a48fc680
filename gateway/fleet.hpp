/// The configuration of a gateway, in the TOML of the configuration file of the command:
///
///     [fleet]
///     name = "studio"
///
///     [gimbal.front]
///     port = "/dev/ttyUSB0"              # and the other keys of config.toml
///     allow = ["move", "stop", "raw"]    # tasks that the broker may command; none by default
///     raw-effects = ["reads", "moves"]   # what messages of `raw` may do; "reads" by default
///     telemetry = ["RealtimeData4 10", "RealtimeDataCustom 5 IMU_ANGLES|RC_DATA"]
///     units = "yes"                      # telemetry has the values in their units, too
///
///     [metrics]
///     listen = "127.0.0.1:9110"
///
///     [broker]
///     address = "127.0.0.1:1883"         # or a list, of a cluster
///     journal = "/var/lib/sbgc-gateway/studio.db"
///
/// Names consist of a-z, 0-9, _ and -.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/meta.hpp>

#include "board/configuration.hpp"
#include "gateway/telemetry_source.hpp"

namespace sbgc::tools {

/// The tasks in command topics of a broker, as in `…/cmd/<task>`; `raw` is `…/raw`.
inline constexpr std::array<std::string_view, 10> gateway_tasks{
    "stop", "move", "speed", "motors", "home", "menu", "calibrate", "get", "set", "raw"};

/// Messages of one type that a gimbal sends at a rate.
struct Telemetry {
  TelemetrySource source;
  double rate{};  ///< per second
};

struct FleetGimbal {
  NamedGimbal line{};                ///< name, port and connection options
  std::vector<std::string> allow{};  ///< of gateway_tasks
  Effects raw_effects = Effect::reads;
  std::vector<Telemetry> telemetry{};
  bool has_units{};  ///< in its telemetry

  bool allows(std::string_view task) const;
};

struct MetricsSettings {
  std::string listen{"127.0.0.1:9110"};       ///< an IPv4 address and a port
  std::chrono::milliseconds interval{5'000};  ///< between two requests for live data
  std::set<std::string> paths{};              ///< of the fields of live data that become metrics
};

struct BrokerAddress {
  std::string host{};
  std::uint16_t port{};
};

struct BrokerSettings {
  std::vector<BrokerAddress> addresses{};  ///< of one broker, or of the servers of a cluster
  bool is_mqtt_5 = false;                  ///< otherwise 3.1.1
  std::string client_id{};                 ///< by default "sbgc-<fleet>"
  std::string user{};
  std::string password_file{};
  std::string ca_file{};           ///< with one, TLS
  std::string certificate_file{};  ///< of the client
  std::string key_file{};
  std::chrono::milliseconds keep_alive{30'000};
  std::filesystem::path journal{};   ///< the SQLite file
  std::size_t most_waiting{10'000};  ///< events and results on disk
  std::size_t history{10'000};       ///< results for recognizing repeated commands
  std::chrono::milliseconds longest_deadline{60'000};  ///< of a command
  std::chrono::milliseconds clock_skew{1'000};         ///< the maximum clock difference of senders
  std::chrono::milliseconds stop_after{2'000};  ///< without the broker, a moving gimbal stops
};

/// A file that the configuration names, and the position of the name.
struct FleetFile {
  enum class Kind : std::uint8_t { password, authorities, certificate, key, journal };

  Kind kind{};
  std::filesystem::path path{};
  ConfigurationPlace place{};
};

struct Fleet {
  std::string name{};
  std::vector<FleetGimbal> gimbals{};
  std::optional<MetricsSettings> metrics{};
  std::optional<BrokerSettings> broker{};
  std::vector<FleetFile> files{};
};

/// Parses the fleet in the text of a file. Throws CommandError, with "file:line:column: ", if it is
/// invalid. Relative paths are relative to the folder of the file. Accesses no files.
Fleet fleet_in(const std::string& text, const std::filesystem::path& file);

/// Reads the file, and checks those that it names. Throws CommandError for anything that would
/// prevent the start of a gateway. Creates, locks and changes nothing.
Fleet read_fleet(const std::filesystem::path& file);

}  // namespace sbgc::tools
