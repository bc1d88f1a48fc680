#include "gateway/fleet.hpp"

#include <algorithm>
#include <charconv>
#include <utility>
#include <variant>

#include <asio/ip/address.hpp>
#include <fmt/format.h>

#include <sbgc/internal/characters.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/io/internal/real_path.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/meta/realtime.hpp>

#include "command/command_error.hpp"
#include "command/option_values.hpp"
#include "command/wording.hpp"
#include "frames/stream_type.hpp"
#include "values/effect_text.hpp"
#include "values/field_patterns.hpp"

namespace sbgc::tools {

namespace {

// Topics of the gateway itself have these names in place of a gimbal.
constexpr std::array<std::string_view, 2> reserved_names{"gateway", "reply"};
constexpr double slowest_telemetry = 0.02;
constexpr double fastest_telemetry = 1000;
constexpr std::size_t most_kept = 10'000'000;
constexpr std::chrono::seconds longest_keep_alive{65'535};  // of MQTT
constexpr std::chrono::seconds longest_clock_skew{60};
constexpr std::chrono::seconds longest_stop_after{60};
constexpr std::chrono::hours farthest_deadline{24};
constexpr std::uint16_t mqtt_port = 1883;
constexpr std::uint16_t mqtt_tls_port = 8883;
constexpr std::size_t longest_host = 253;  // of DNS
/// Fields of live data that become metrics, as for `sbgc stream --fields`.
constexpr const char* usual_fields =
    "bat_level,current,motor_power,balance_error,imu_temperature,cycle_time,i2c_error_count,"
    "serial_error_cnt,system_error,angle";

bool is_fleet_name(std::string_view name) {
  return !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

template <class Words>
std::vector<std::string> as_strings(const Words& words) {
  return {std::begin(words), std::end(words)};
}

std::vector<std::string> read_allowed(SectionReader& section) {
  std::vector<std::string> result;
  const std::vector<std::string> tasks = as_strings(gateway_tasks);
  if (const auto* const words = section.texts("allow")) {
    for (const ConfigurationValue& word : *words) {
      if (std::ranges::find(tasks, word.text) == tasks.end()) {
        section.reject(word,
                       fmt::format("no task '{}'{}", word.text,
                                   detail::did_you_mean(
                                       detail::nearest(word.text, tasks),
                                       "tasks are " + detail::alternatives(tasks, false, "and"))));
      }
      result.push_back(word.text);
    }
  }
  return result;
}

Effects read_effects(SectionReader& section, Effects by_default) {
  const auto* const words = section.texts("raw-effects");
  if (words == nullptr) return by_default;
  Effects result;
  for (const ConfigurationValue& word : *words) {
    const std::optional<Effect> effect = effect_of_word(word.text);
    if (!effect) {
      const std::vector<std::string> known = known_effect_words();
      section.reject(word,
                     fmt::format("no effect '{}'{}", word.text,
                                 detail::did_you_mean(
                                     detail::nearest(word.text, known),
                                     "effects are " + detail::alternatives(known, false, "and"))));
    }
    result = result | *effect;
  }
  return result;
}

/// Parses "MESSAGE RATE [CONTENTS]".
Telemetry read_telemetry(const SectionReader& section, const ConfigurationValue& value) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < value.text.size();) {
    const std::size_t space = std::min(value.text.find(' ', at), value.text.size());
    if (space != at) words.push_back(value.text.substr(at, space - at));
    at = space + 1;
  }
  constexpr std::size_t most_words = 3;
  double rate{};
  const bool is_complete =
      (words.size() == 2 || words.size() == most_words) &&
      std::from_chars(words[1].data(), words[1].data() + words[1].size(), rate).ptr ==
          words[1].data() + words[1].size();
  if (!is_complete || !(rate >= slowest_telemetry && rate <= fastest_telemetry)) {
    section.reject(value,
                   fmt::format("'{}' is not a message and its rate, from {} to {} per second, such "
                               "as \"RealtimeData4 10\"",
                               value.text, slowest_telemetry, fastest_telemetry));
  }
  try {
    return {TelemetrySource::find(words[0], words.size() == most_words ? words[2] : ""), rate};
  } catch (const CommandError& error) {
    section.reject(value, error.what());
  }
}

std::vector<Telemetry> read_all_telemetry(SectionReader& section) {
  std::vector<Telemetry> result;
  if (const auto* const texts = section.texts("telemetry")) {
    for (const ConfigurationValue& text : *texts) {
      Telemetry one = read_telemetry(section, text);
      const auto is_same = [&](const Telemetry& other) {
        return &other.source.info() == &one.source.info();
      };
      if (std::ranges::any_of(result, is_same)) {
        section.reject(text, fmt::format("{} is there twice", one.source.info().name));
      }
      result.push_back(std::move(one));
    }
  }
  return result;
}

/// Returns the paths of live data that the patterns select. Throws CommandError.
std::set<std::string> live_paths(const std::string& patterns) {
  const MessageInfo& info = Meta<msg::RealtimeData4>::info;
  std::vector<std::string> paths;
  for (const StreamField& field : StreamType::find(info.name).fields()) paths.push_back(field.path);
  const std::vector<bool> chosen = chosen_fields(patterns, *find_message(info.name), paths);
  std::set<std::string> result;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (chosen[i]) result.insert(paths[i]);
  }
  return result;
}

/// Parses "HOST:PORT", or with a default port, "HOST"; IPv6 addresses are in brackets.
std::optional<BrokerAddress> read_host_and_port(std::string_view text,
                                                std::optional<std::uint16_t> usual_port) {
  const std::size_t colon = text.rfind(':');
  const bool has_port = colon != text.npos && text.find(']', colon) == text.npos;
  if (!has_port && !usual_port) return {};
  BrokerAddress address{std::string(text.substr(0, has_port ? colon : text.size())),
                        usual_port.value_or(0)};
  if (has_port) {
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + colon + 1, end, address.port);
    if (read.ec != std::errc{} || read.ptr != end) return {};
  }
  std::string& host = address.host;
  if (host.starts_with('[') && host.ends_with(']')) {
    host = host.substr(1, host.size() - 2);
    std::error_code error;
    asio::ip::make_address_v6(host, error);
    return error ? std::nullopt : std::optional(address);
  }
  const bool is_host = std::ranges::all_of(host, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-' || c == '_';
  });
  if (!is_host || host.empty() || host.size() > longest_host) return {};
  return address;
}

/// Parses an IPv4 address: the metrics library supports no other.
std::string read_listen(const SectionReader& section, const std::string& text) {
  auto address = read_host_and_port(text, {});
  if (address && address->host == "localhost") address->host = "127.0.0.1";
  std::error_code error;
  if (address) asio::ip::make_address_v4(address->host, error);
  if (!address || error) {
    section.reject("listen", fmt::format("'listen' is '{}'; it must be an IPv4 address and a port, "
                                         "such as \"127.0.0.1:9110\"",
                                         text));
  }
  return fmt::format("{}:{}", address->host, address->port);
}

MetricsSettings read_metrics(SectionReader& section) {
  MetricsSettings metrics;
  if (const auto listen = section.text("listen")) metrics.listen = read_listen(section, *listen);
  if (const auto interval = section.duration("interval")) metrics.interval = *interval;
  try {
    metrics.paths = live_paths(section.text("fields").value_or(usual_fields));
  } catch (const CommandError& error) {
    section.reject("fields", error.what());
  }
  return metrics;
}

BrokerAddress read_broker_address(const SectionReader& section, const ConfigurationValue& value,
                                  std::uint16_t usual_port) {
  const auto address = read_host_and_port(value.text, usual_port);
  if (!address || address->port == 0) {
    section.reject(value, fmt::format("'{}' is not an address, such as \"127.0.0.1:1883\" or "
                                      "\"broker.example:8883\"",
                                      value.text));
  }
  return *address;
}

/// Reads a text that is valid in MQTT packets.
std::string read_mqtt_text(SectionReader& section, const char* key) {
  std::string text = section.text(key).value_or("");
  bool is_allowed = true;
  detail::for_each_sequence(text, [&](std::string_view sequence, bool is_utf8) {
    const char32_t code = is_utf8 ? detail::code_point(sequence) : 0;
    const bool is_character = (code & 0xFFFEU) != 0xFFFE && (code < 0xFDD0 || code > 0xFDEF);
    is_allowed = is_allowed && is_utf8 && is_character && !detail::is_control(code);
  });
  if (!is_allowed) {
    section.reject(key, fmt::format("'{}' has characters that MQTT does not allow", key));
  }
  return text;
}

/// Reads the names of the files in a section.
class FileReader {
 public:
  FileReader(SectionReader& section, const std::filesystem::path& folder,
             std::vector<FleetFile>& files)
      : section_(section), folder_(folder), files_(files) {}

  std::string read(FleetFile::Kind kind, const char* key) {
    return add(kind, key, section_.text(key).value_or(""));
  }
  std::string add(FleetFile::Kind kind, const char* key, const std::string& name) {
    if (name.empty()) return "";
    files_.push_back({kind, folder_ / name, section_.place_of(key)});
    return files_.back().path.string();
  }

 private:
  SectionReader& section_;
  const std::filesystem::path& folder_;
  std::vector<FleetFile>& files_;
};

BrokerSettings read_broker(SectionReader& section, FileReader files) {
  using Kind = FleetFile::Kind;
  BrokerSettings broker;
  broker.ca_file = files.read(Kind::authorities, "ca-file");
  const std::uint16_t usual_port = broker.ca_file.empty() ? mqtt_port : mqtt_tls_port;
  for (const ConfigurationValue& value :
       section.required_texts("address", "address = \"127.0.0.1:1883\"")) {
    broker.addresses.push_back(read_broker_address(section, value, usual_port));
  }
  if (const auto version = section.text("mqtt")) {
    broker.is_mqtt_5 = *version == "5";
    if (!broker.is_mqtt_5 && *version != "3.1.1") {
      section.reject("mqtt",
                     fmt::format("'mqtt' is '{}'; it must be \"3.1.1\" or \"5\"", *version));
    }
  }
  broker.client_id = read_mqtt_text(section, "client-id");
  broker.user = read_mqtt_text(section, "user");
  broker.password_file = files.read(Kind::password, "password-file");
  broker.certificate_file = files.read(Kind::certificate, "certificate-file");
  broker.key_file = files.read(Kind::key, "key-file");
  if (broker.certificate_file.empty() != broker.key_file.empty()) {
    section.reject(broker.key_file.empty() ? "certificate-file" : "key-file",
                   "'certificate-file' and 'key-file' belong together");
  }
  if (broker.ca_file.empty() && !broker.key_file.empty()) {
    section.reject("key-file",
                   "a certificate needs TLS: add ca-file, the certificates of those "
                   "who may sign that of the broker");
  }
  if (!broker.password_file.empty() && broker.user.empty()) {
    section.reject("password-file", "a password needs a user: add user = \"…\"");
  }
  const auto read_time = [&](const char* key, std::chrono::seconds longest,
                             std::chrono::milliseconds& into) {
    const auto time = section.duration(key);
    if (!time) return;
    if (*time > longest) {
      section.reject(key, fmt::format("'{}' is {}; it can be at most {}", key, duration_text(*time),
                                      duration_text(longest)));
    }
    into = *time;
  };
  read_time("keep-alive", longest_keep_alive, broker.keep_alive);
  read_time("clock-skew", longest_clock_skew, broker.clock_skew);
  read_time("stop-after", longest_stop_after, broker.stop_after);
  read_time("longest-deadline", farthest_deadline, broker.longest_deadline);
  const auto read_count = [&](const char* key, std::size_t& into) {
    if (const auto count = section.count(key, 1, most_kept)) into = *count;
  };
  read_count("most-waiting", broker.most_waiting);
  read_count("history", broker.history);
  broker.journal = files.add(
      Kind::journal, "journal",
      section.required_text("journal",
                            "journal = \"/var/lib/sbgc-gateway/studio.db\", a file of the "
                            "gateway for what must not be lost"));
  return broker;
}

FleetGimbal read_fleet_gimbal(SectionReader& section, const ConfigurationSection& where,
                              const std::filesystem::path& folder, FileReader files) {
  const std::string& name = where.path.back();
  if (!is_fleet_name(name)) {
    section.reject("", fmt::format("'{}' cannot be a part of a topic: names of gimbals consist of "
                                   "a-z, 0-9, _ and -",
                                   name));
  }
  if (std::ranges::find(reserved_names, name) != reserved_names.end()) {
    section.reject("", fmt::format("'{}' has another meaning in topics; take another name", name));
  }
  FleetGimbal gimbal;
  gimbal.line = read_gimbal(section, name, folder);
  const io::AddressResult address = io::parse_address(gimbal.line.port);
  if (!gimbal.line.port.empty() && !address) {
    section.reject("port", as_message(address.error.message));
  }
  gimbal.allow = read_allowed(section);
  gimbal.raw_effects = read_effects(section, gimbal.raw_effects);
  gimbal.telemetry = read_all_telemetry(section);
  const std::string units = section.text("units").value_or("no");
  if (units != "yes" && units != "no") section.reject("units", "'units' must be \"yes\" or \"no\"");
  gimbal.has_units = units == "yes";
  if (gimbal.line.password_file == "-") {
    section.reject("password-file", "a gateway has nobody to ask: name a file");
  }
  files.add(FleetFile::Kind::password, "password-file", gimbal.line.password_file);
  return gimbal;
}

/// True if both addresses lead to one board. Replays of a capture are independent.
bool is_same_board(const std::string& a, const std::string& b) {
  const io::AddressResult one = io::parse_address(a);
  const io::AddressResult other = io::parse_address(b);
  if (!one || !other) return false;
  const auto* const port = std::get_if<io::SerialAddress>(&one.address);
  const auto* const other_port = std::get_if<io::SerialAddress>(&other.address);
  if (port != nullptr && other_port != nullptr) {
    return io::detail::real_path(port->path) == io::detail::real_path(other_port->path);
  }
  return one.address == other.address && !std::holds_alternative<io::CaptureAddress>(one.address);
}

/// Reads one section into the fleet.
void read_section(const ConfigurationText& text, const ConfigurationSection& section, Fleet& fleet,
                  const std::filesystem::path& folder) {
  SectionReader reader(text, section);
  const FileReader files(reader, folder, fleet.files);
  const std::vector<std::string>& path = section.path;
  if (path.size() == 2 && path.front() == "gimbal") {
    FleetGimbal gimbal = read_fleet_gimbal(reader, section, folder, files);
    for (const FleetGimbal& other : fleet.gimbals) {
      if (!is_same_board(gimbal.line.port, other.line.port)) continue;
      reader.reject("port", fmt::format("[gimbal.{}] has the port of [gimbal.{}], {}",
                                        gimbal.line.name, other.line.name, other.line.port));
    }
    fleet.gimbals.push_back(std::move(gimbal));
  } else if (path == std::vector<std::string>{"fleet"}) {
    fleet.name = reader.required_text("name", "name = \"studio\"");
  } else if (path == std::vector<std::string>{"metrics"}) {
    fleet.metrics = read_metrics(reader);
  } else if (path == std::vector<std::string>{"broker"}) {
    fleet.broker = read_broker(reader, files);
  } else if (path.empty() && section.keys.empty()) {
    return;
  } else {
    const std::vector<std::string> known{"fleet", "gimbal", "metrics", "broker"};
    const auto& at = path.empty() ? section.keys.front().place : section.place;
    text.reject(at, fmt::format("{} is not a section of a fleet{}", section.name(),
                                detail::did_you_mean(
                                    path.empty() ? std::vector<std::string>{}
                                                 : detail::nearest(path.front(), known),
                                    "there are [fleet], [gimbal.NAME], [metrics] and [broker]")));
  }
  reader.finish();
  if (!fleet.name.empty() && !is_fleet_name(fleet.name)) {
    reader.reject("name", fmt::format("'{}' cannot be a part of a topic: the name of a fleet "
                                      "consists of a-z, 0-9, _ and -",
                                      fleet.name));
  }
}

}  // namespace

bool FleetGimbal::allows(std::string_view task) const {
  return std::ranges::find(allow, task) != allow.end();
}

Fleet fleet_in(const std::string& text, const std::filesystem::path& file) {
  const ConfigurationText configuration(text, file.string());
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  Fleet fleet;
  for (const ConfigurationSection& section : configuration.sections()) {
    read_section(configuration, section, fleet, folder);
  }
  const auto lack = [&](const char* what) {
    configuration.reject({}, fmt::format("{} is missing", what));
  };
  if (fleet.name.empty()) lack("[fleet] with its name, such as name = \"studio\",");
  if (fleet.gimbals.empty()) lack("a section [gimbal.NAME] with a port");
  if (!fleet.metrics && !fleet.broker) lack("[metrics] or [broker], the reason for a gateway,");
  return fleet;
}

}  // namespace sbgc::tools
