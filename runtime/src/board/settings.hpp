/// The settings of the board: those in use, and those in the EEPROM.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

#include <sbgc/board/memory.hpp>
#include <sbgc/exchange.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/settings.hpp>

namespace sbgc::board {

/// Settings are bodies of StoredMessages. Those of the active profile are in use: they can differ
/// from the EEPROM by adjustable variables, until save() or a restart.
class Settings {
 public:
  /// Loads what the EEPROM has; what is missing or damaged there becomes the factory settings, in
  /// use but not in the EEPROM.
  explicit Settings(Memory& memory);

  /// As after a restart.
  void reload();

  std::uint8_t profile() const;
  /// Takes the settings of another profile into use. Precondition: there is such a profile.
  void select_profile(std::uint8_t profile);

  /// In use.
  template <class M>
  const M& of() const {
    return std::get<M>(in_use_);
  }

  /// What a request reads: of the active profile what is in use, of others what the EEPROM has.
  /// Precondition: copy < SettingsOf<M>::copies.
  template <class M>
  M read(std::uint8_t copy) const;
  /// Stores in the EEPROM, reserved bytes and tail with it, and takes into use what is of the
  /// active profile. False if the EEPROM has no room for so long a body.
  template <class M>
  bool write(std::uint8_t copy, const M& settings);

  /// The variable's value; nothing if it is none of this board's.
  std::optional<std::int32_t> variable(VariableId id) const;
  /// Until restart or save(). False if there is no such variable or its range forbids the value.
  bool set_variable(VariableId id, std::int32_t value);
  /// Stores what is in use in the active profile.
  void save();

  /// Factory settings for one profile, in the EEPROM and in use.
  void use_defaults(std::uint8_t profile);
  /// Erases the whole EEPROM, files and user data with it; factory settings are in use.
  void erase();

  /// Counts changes of what is in use.
  std::uint32_t version() const;
};

}  // namespace sbgc::board
