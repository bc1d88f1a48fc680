#include "serving/memory_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include <sbgc/internal/crc32.hpp>
#include <sbgc/internal/own_json.hpp>
#include <sbgc/io/internal/atomic_file.hpp>
#include <sbgc/io/internal/own_file.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/parameters.hpp>

namespace sbgc::serving {
namespace {

using emulator::ImuCalibration;
using emulator::Memory;

constexpr const char* format_name = "sbgc-board-memory";
constexpr std::uint64_t format_version = 1;
/// Larger than any valid file.
constexpr std::size_t largest_file = std::size_t{1} << 20U;
/// More than the parameters of all profiles.
constexpr std::size_t largest_blob = Memory::eeprom_size;
/// Bytes per line of text.
constexpr std::size_t line_size = 64;
/// Exceeds all values of a board and is small enough that arithmetic does not overflow.
constexpr double largest_number = 1e6;

static_assert(Memory::eeprom_size % line_size == 0);

// Reading and writing share these lists of names and members.

template <class Calibration, class Use>
  requires std::same_as<std::remove_const_t<Calibration>, ImuCalibration>
void for_each_member(Calibration& imu, Use&& use) {
  use("gyro_is_calibrated", imu.gyro_is_calibrated);
  use("acc_limits", imu.acc_limits);
  use("gyro_temperature_enabled", imu.gyro_temperature_enabled);
  use("acc_temperature_enabled", imu.acc_temperature_enabled);
  use("gyro_temperature_min", imu.gyro_temperature_min);
  use("gyro_temperature_max", imu.gyro_temperature_max);
  use("acc_temperature_min", imu.acc_temperature_min);
  use("acc_temperature_max", imu.acc_temperature_max);
  use("acc_slots", imu.acc_slots);
  use("gyro_offset", imu.gyro_offset);
}

template <class Owner, class Use>
  requires std::same_as<std::remove_const_t<Owner>, MemoryOwner>
void for_each_member(Owner& owner, Use&& use) {
  use("version", owner.board);
  use("firmware", owner.firmware);
  use("device_id", owner.device_id);
  use("mcu_id", owner.mcu_id);
}

/// Members that files of earlier versions lack.
template <class Saved, class Use>
void for_each_later_member(Saved&& memory, Use&& use) {
  use("profile_sets", memory.profile_sets);
  use("profile_set", memory.profile_set);
  use("state_variables", memory.state_variables);
  use("pass_protect", memory.pass_protect);
}

/// A value with a list of members.
template <class T>
concept HasMembers = requires(T& value) {
  for_each_member(value, [](const char*, auto&) {});
};

/// Part of an identity, such as the version of the board.
template <class T>
concept Packed = requires {
  typename T::raw_type;
};

using Blob = std::vector<std::uint8_t>;

struct ToJson {
  template <class T>
    requires std::is_arithmetic_v<T>
  static Json value(T number) { return number; }
  template <Packed T>
  static Json value(T version) {
    return version.raw();
  }
  template <std::size_t n>
  static Json value(const std::array<std::uint8_t, n>& bytes) {
    return detail::to_hex(bytes);
  }
  static Json value(const Xyz<double>& vector) {
    return Json::array({vector.x, vector.y, vector.z});
  }
  template <HasMembers T>
  static Json value(const T& members) {
    Json result = Json::object();
    for_each_member(members,
                    [&](const char* name, const auto& member) { result[name] = value(member); });
    return result;
  }
  template <class T, std::size_t n>
  static Json value(const std::array<T, n>& list) {
    Json result = Json::array();
    for (const T& one : list) result.push_back(value(one));
    return result;
  }
  static Json value(const Blob& all) {
    Json lines = Json::array();
    for (std::span<const std::uint8_t> bytes(all); !bytes.empty();) {
      const auto line = bytes.first(std::min(bytes.size(), line_size));
      lines.push_back(detail::to_hex(line));
      bytes = bytes.subspan(line.size());
    }
    return lines;
  }
};

Json document_of(const SavedMemory& saved) {
  const Memory& memory = saved.memory;
  Json document{{"format", format_name},
                {"version", format_version},
                {"board", ToJson::value(saved.owner)},
                {"profile", memory.profile},
                {"battery_factor", memory.battery_factor},
                {"imus", ToJson::value(memory.imus)},
                {"sensors", ToJson::value(memory.sensors)},
                {"eeprom", ToJson::value(memory.eeprom)}};
  // Only if there is something to save, so that files of boards without these stay the same.
  Json of_new_board;
  for_each_later_member(Memory{}, [&](const char* name, const auto& member) {
    of_new_board[name] = ToJson::value(member);
  });
  for_each_later_member(memory, [&](const char* name, const auto& member) {
    Json value = ToJson::value(member);
    if (value != of_new_board[name]) document[name] = std::move(value);
  });
  return document;
}

/// Returns the checksum of a document as written.
std::string checksum_of(const Json& document) {
  const std::string text = document.dump();
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  return fmt::format("{:08x}", sbgc::detail::crc32(bytes));
}

/// Reads a document and remembers its first error.
class Reader {
 public:
  Result<SavedMemory> read(const Json& document) {
    const Json version = document.value("version", Json());
    if (version.is_number_unsigned() && version > format_version) {
      return ClientError{ErrorCode::incompatible,
                         fmt::format("version {} of the format is not supported, only {}",
                                     version.get<std::uint64_t>(), format_version)};
    }
    SavedMemory saved;
    std::string checksum;
    members(document, "", [&](auto& use) {
      std::string format;
      std::uint8_t number{};
      use("format", format);
      use("version", number);
      if (number != format_version) fail("version", fmt::format("expected {}", format_version));
      use("board", saved.owner);
      use("profile", saved.memory.profile);
      use("battery_factor", saved.memory.battery_factor);
      use("imus", saved.memory.imus);
      use("sensors", saved.memory.sensors);
      use("eeprom", saved.memory.eeprom);
      for_each_later_member(saved.memory, [&](const char* name, auto& member) {
        if (document.contains(name)) use(name, member);
      });
      use("crc32", checksum);
    });
    constexpr unsigned profiles = ParametersOf<msg::ReadParams3>::copies;
    if (saved.memory.profile >= profiles) {
      fail("profile", fmt::format("expected a number below {}", profiles));
    }
    if (saved.memory.profile_set < 1 || saved.memory.profile_set > Memory::profile_set_slots) {
      fail("profile_set", fmt::format("expected a number from 1 to {}", Memory::profile_set_slots));
    }
    if (saved.memory.battery_factor < 0) fail("battery_factor", "must not be negative");
    if (error_.empty() && checksum != checksum_of(document_of(saved))) {
      fail("crc32", "wrong checksum: the file was modified or damaged");
    }
    if (!error_.empty()) return ClientError{ErrorCode::bad_file, error_};
    return saved;
  }

 private:
  /// Calls `list(use)`, which calls `use(name, member)` for each required member of the object.
  template <class List>
  void members(const Json& object, const std::string& path, List&& list) {
    if (!object.is_object()) return fail(path, "expected an object");
    std::vector<std::string> known;
    auto use = [&](const char* name, auto& member) {
      known.emplace_back(name);
      const std::string inner = path.empty() ? name : path + "." + name;
      const auto found = object.find(name);
      if (found == object.end()) return fail(inner, "it is missing");
      value(*found, inner, member);
    };
    list(use);
    for (const auto& item : object.items()) {
      if (std::ranges::find(known, item.key()) != known.end()) continue;
      fail(path.empty() ? item.key() : path + "." + item.key(), "unknown key");
    }
  }

  template <class T>
    requires std::is_integral_v<T>
  void value(const Json& json, const std::string& path, T& out) {
    constexpr auto lowest = std::int64_t{std::numeric_limits<T>::min()};
    constexpr auto highest = std::int64_t{std::numeric_limits<T>::max()};
    const bool fits = json.is_number_unsigned()
                          ? json.get<std::uint64_t>() <= static_cast<std::uint64_t>(highest)
                          : json.is_number_integer() && json.get<std::int64_t>() >= lowest;
    if (!fits) return fail(path, fmt::format("expected a number from {} to {}", lowest, highest));
    out = static_cast<T>(json.get<std::int64_t>());
  }
  void value(const Json& json, const std::string& path, bool& out) {
    if (!json.is_boolean()) return fail(path, "expected true or false");
    out = json.get<bool>();
  }
  void value(const Json& json, const std::string& path, double& out) {
    const double number = json.is_number() ? json.get<double>() : largest_number + 1;
    if (!(std::abs(number) <= largest_number)) return fail(path, "expected a number");
    out = number;
  }
  void value(const Json& json, const std::string& path, std::string& out) {
    if (!json.is_string()) return fail(path, "expected a string");
    out = json.get<std::string>();
  }
  template <Packed T>
  void value(const Json& json, const std::string& path, T& out) {
    typename T::raw_type raw{};
    value(json, path, raw);
    out = T(raw);
  }
  template <std::size_t n>
  void value(const Json& json, const std::string& path, std::array<std::uint8_t, n>& out) {
    bytes(json, path, out);
  }
  void value(const Json& json, const std::string& path, Xyz<double>& out) {
    constexpr std::size_t size = Xyz<double>::size();
    if (!json.is_array() || json.size() != size) return fail(path, "expected 3 numbers");
    for (std::size_t i = 0; i < size; ++i) value(json[i], at(path, i), out[i]);
  }
  template <HasMembers T>
  void value(const Json& json, const std::string& path, T& out) {
    members(json, path, [&](auto& use) { for_each_member(out, use); });
  }
  template <class T, std::size_t n>
  void value(const Json& json, const std::string& path, std::array<T, n>& out) {
    if (!json.is_array() || json.size() != n) {
      return fail(path, fmt::format("expected a list of {}", n));
    }
    for (std::size_t i = 0; i < n; ++i) value(json[i], at(path, i), out[i]);
  }
  /// Bytes split into lines; all lines but the last one are full.
  void value(const Json& json, const std::string& path, Blob& out) {
    const std::size_t whole = path == "eeprom" ? Memory::eeprom_size : largest_blob;
    const std::size_t lines = (whole + line_size - 1) / line_size;
    const bool fits = json.is_array() && json.size() <= lines;
    if (!fits || (path == "eeprom" && json.size() != lines)) {
      return fail(path, fmt::format("expected a list of {} strings", lines));
    }
    out.clear();
    for (std::size_t i = 0; i < json.size(); ++i) {
      const bool is_last = path != "eeprom" && i + 1 == json.size();
      const std::size_t size = is_last && json[i].is_string()
                                   ? json[i].get_ref<const std::string&>().size() / 2
                                   : line_size;
      out.resize(out.size() + std::min(size, line_size));
      bytes(json[i], at(path, i), std::span(out).last(std::min(size, line_size)));
    }
  }
  void bytes(const Json& json, const std::string& path, std::span<std::uint8_t> out) {
    const auto found =
        json.is_string() ? detail::from_hex(json.get_ref<const std::string&>()) : std::nullopt;
    if (!found || found->size() != out.size()) {
      return fail(path, fmt::format("expected hex digits of {} bytes", out.size()));
    }
    std::ranges::copy(*found, out.begin());
  }

  static std::string at(const std::string& path, std::size_t index) {
    return fmt::format("{}[{}]", path, index);
  }
  void fail(const std::string& path, const std::string& reason) {
    if (error_.empty()) error_ = fmt::format("{}: {}", path, reason);
  }

  std::string error_{};
};

}  // namespace

MemoryOwner owner_of(const emulator::BoardOptions& options) {
  return {options.board, options.firmware, options.device_id, options.mcu_id};
}

std::string to_json_text(const SavedMemory& saved) {
  Json document = document_of(saved);
  std::string checksum = checksum_of(document);
  document["crc32"] = std::move(checksum);
  return document.dump(1) + "\n";
}

Result<SavedMemory> parse_memory(std::string_view text) {
  const Result<Json> document =
      detail::parse_own_json(text, format_name, "the memory of an emulated board");
  if (!document) return document.error();
  return Reader().read(*document);
}

Result<void> save_memory(const std::string& file, const SavedMemory& saved) {
  const std::string text = to_json_text(saved);
  if (const auto right = parse_memory(text); !right) {
    return ClientError{ErrorCode::invalid,
                       fmt::format("not writing {}: {}", file, right.error().message)};
  }
  return detail::write_file_atomically(file, text, Existing::replace);
}

Result<SavedMemory> load_memory(const std::string& file) {
  const Result<std::string> content = detail::read_text_file(file, largest_file);
  if (!content) return content.error();
  Result<SavedMemory> saved = parse_memory(*content);
  if (!saved) {
    return ClientError{saved.error().code, fmt::format("{}: {}", file, saved.error().message)};
  }
  return saved;
}

}  // namespace sbgc::serving
