/// The parameters of the board: those in use and those in the EEPROM.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>

#include <sbgc/emulator/memory.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/adjustable_variables.hpp>
#include <sbgc/meta/parameters.hpp>
#include <sbgc/meta/storage.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/settings.hpp>
#include <sbgc/type_list.hpp>
#include <sbgc/types.hpp>

#include "device/parts/eeprom.hpp"
#include "device/parts/eeprom_records.hpp"
#include "device/parts/factory_parameters.hpp"

namespace sbgc::emulator {

/// One message of each type of a TypeList.
template <class List>
struct OneOfEach;
template <class... Messages>
struct OneOfEach<TypeList<Messages...>> {
  std::tuple<Messages...> messages{};

  template <class M>
  M& of() {
    return std::get<M>(messages);
  }
  template <class M>
  const M& of() const {
    return std::get<M>(messages);
  }
};

/// Parameters are bodies of StoredMessages. Those of the active profile are in use: changes in use
/// only, such as those by adjustable variables, differ from the EEPROM until save() or a restart.
///
/// Fields that are the state of the board (FieldRole::state) are kept as they were sent; the
/// handler of a request fills them in. PROFILE_ID is always the number of the copy.
///
/// General ones (FieldRole::general) are those in the record of the first copy: whichever copy is
/// written, they are stored there and in use at once.
class Parameters {
 public:
  /// Loads the EEPROM; factory parameters replace what is missing or damaged, in use but not in the
  /// EEPROM.
  explicit Parameters(Memory& memory);

  /// As after a restart.
  void reload();

  /// The active profile. An invalid number in the memory counts as 0.
  std::uint8_t profile() const;
  /// Switches to the parameters of another profile. Precondition: it exists.
  void select_profile(std::uint8_t profile);

  /// In use.
  template <class M>
  const M& of() const {
    return in_use_.template of<M>();
  }

  /// What a request reads: parameters in use for the active profile, those in the EEPROM for
  /// others. Precondition: copy < SettingsOf<M>::copies.
  template <class M>
  M read(std::uint8_t copy) const {
    return copy == copy_in_use<M>() ? of<M>() : stored<M>(copy);
  }
  /// Stores a message in the EEPROM, including reserved bytes and tail, and uses it if it belongs
  /// to the active profile. False if the body is too long for the EEPROM. Same precondition.
  template <class M>
  bool write(std::uint8_t copy, const M& parameters) {
    M numbered = parameters;
    set_copy(numbered, copy);
    if (!store(copy, numbered)) return false;
    if (copy == copy_in_use<M>()) {
      use(numbered);
    } else {
      share(numbered, in_use_.template of<M>());
    }
    return true;
  }
  /// Changes some parameters, in the EEPROM and in use: `edit(M&)` is called for both. Other
  /// unsaved changes stay as they are. Otherwise as write().
  template <class M, class Edit>
  bool change(std::uint8_t copy, const Edit& edit) {
    auto parameters = stored<M>(copy);
    edit(parameters);
    if (!store(copy, parameters)) return false;
    auto& in_use = in_use_.template of<M>();
    if (copy == copy_in_use<M>()) {
      edit(in_use);
    } else {
      share(parameters, in_use);
    }
    return true;
  }

  /// Changes some parameters in use, until a restart, another profile or save().
  template <class M, class Edit>
  void change_in_use(const Edit& edit) {
    edit(in_use_.template of<M>());
  }

  /// The variable's value; empty if this board does not have it.
  std::optional<std::int32_t> variable(msg::VariableId id) const;
  /// Until a restart or save(). False if there is no such variable or the value is out of range.
  /// Afterwards variable() is this value, even where the parameters can only approximate it.
  bool set_variable(msg::VariableId id, std::int32_t value);
  /// Sets all of them, or none if one cannot be set; returns that one.
  std::optional<msg::VariableId> set_variables(std::span<const msg::AdjVarValue> values);
  /// Stores what is in use in the active profile.
  void save();

  /// Restores the factory parameters of one profile, in the EEPROM and in use; general ones stay as
  /// they are. Precondition: the profile exists.
  void use_defaults(std::uint8_t profile);
  /// Erases the whole EEPROM, including files and user data; factory parameters are in use, the
  /// first profile is active.
  void erase();

 private:
  /// A variable that a host has set.
  struct Variable {
    std::int32_t given{};
    Optional<std::int32_t> made{};  ///< the resulting parameter; empty if the variable has none
  };

  /// Whether each profile has a copy of the message; of all others there is one.
  template <class M>
  static constexpr bool is_of_profile = (SettingsOf<M>::copies > 1);

  template <class M>
  std::uint8_t copy_in_use() const {
    return is_of_profile<M> ? profile() : std::uint8_t{0};
  }
  template <class M>
  static void set_copy(M& message, std::uint8_t copy) {
    if constexpr (is_of_profile<M>) SettingsOf<M>::copy(message) = copy;
  }
  template <class M>
  static void share([[maybe_unused]] const M& from, [[maybe_unused]] M& to) {
    if constexpr (is_of_profile<M>) SettingsOf<M>::share(from, to);
  }
  /// Address of the record of a copy.
  template <class M>
  static std::size_t place(std::uint8_t copy) {
    std::size_t before = 0;
    bool found = false;
    StoredMessages::for_each([&]<class Other>(Type<Other>) {
      found = found || std::is_same_v<M, Other>;
      if (!found) before += SettingsOf<Other>::copies;
    });
    return layout::parameters + (before + copy) * record_size();
  }
  template <class M>
  M stored(std::uint8_t copy) const {
    M message = record<M>(copy);
    if (copy != 0) share(record<M>(0), message);
    return message;
  }
  /// The copy in the EEPROM, or the factory parameters.
  template <class M>
  M record(std::uint8_t copy) const {
    M message{};
    const auto body = read_record(eeprom_, place<M>(copy), {M::command, copy});
    if (!body || !decode(std::span(*body), message)) message = factory_parameters<M>(copy);
    set_copy(message, copy);
    return message;
  }
  template <class M>
  bool store(std::uint8_t copy, const M& message) {
    if (!store_record(copy, message)) return false;
    if (copy == 0) return true;
    const M before = record<M>(0);
    M first = before;
    share(message, first);
    return first == before || store_record(0, first);  // as long as before, so there is room
  }
  template <class M>
  bool store_record(std::uint8_t copy, const M& message) {
    std::array<std::uint8_t, max_body_size> body{};
    const WriteResult written = encode(message, body);
    return written && write_record(eeprom_, place<M>(copy), {M::command, copy},
                                   std::span(body).first(written.size));
  }
  template <class M>
  void use(const M& message) {
    if (is_of_profile<M>) forget_variables();
    in_use_.template of<M>() = message;
  }
  /// Variables that set parameters have the parameters' values again.
  void forget_variables();

  Memory& memory_;
  Eeprom eeprom_;
  OneOfEach<StoredMessages> in_use_{};
  std::map<msg::VariableId, Variable> variables_{};  ///< that have been set
};

}  // namespace sbgc::emulator
