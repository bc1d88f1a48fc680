/// The parameters of the board: those in use, and those in the EEPROM.
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

/// Parameters are bodies of StoredMessages. Those of the active profile are in use: they can differ
/// from the EEPROM by what has been changed in use only, as by adjustable variables, until save()
/// or a restart.
///
/// Fields that are the state of the board (FieldRole::state) are kept as they were sent; who
/// answers a request fills them in. PROFILE_ID is always the number of the copy.
///
/// General ones (FieldRole::general) count in the record of the first copy: whichever copy is
/// written, they are stored there and in use at once.
class Parameters {
 public:
  /// Loads what the EEPROM has; what is missing or damaged there becomes the factory parameters, in
  /// use but not in the EEPROM.
  explicit Parameters(Memory& memory);

  /// As after a restart.
  void reload();

  /// The active one. A number in the memory that no profile has counts as 0.
  std::uint8_t profile() const;
  /// Takes the parameters of another profile into use. Precondition: there is such a profile.
  void select_profile(std::uint8_t profile);

  /// In use.
  template <class M>
  const M& of() const {
    return in_use_.template of<M>();
  }

  /// What a request reads: of the active profile what is in use, of others what the EEPROM has.
  /// Precondition: copy < SettingsOf<M>::copies.
  template <class M>
  M read(std::uint8_t copy) const {
    return copy == copy_in_use<M>() ? of<M>() : stored<M>(copy);
  }
  /// Stores in the EEPROM, reserved bytes and tail with it, and takes into use what is of the
  /// active profile. False if the EEPROM has no room for so long a body. Same precondition.
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
  /// Changes some of the parameters, in the EEPROM and in use: `edit(M&)` is called for both. What
  /// else is in use and not saved stays as it is. Otherwise as write().
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

  /// Changes some of those in use, until restart, another profile or save().
  template <class M, class Edit>
  void change_in_use(const Edit& edit) {
    edit(in_use_.template of<M>());
  }

  /// The variable's value; nothing if it is none of this board's.
  std::optional<std::int32_t> variable(msg::VariableId id) const;
  /// Until restart or save(). False if there is no such variable or its range forbids the value.
  /// variable() is this value then, even where the parameters can only come near to it.
  bool set_variable(msg::VariableId id, std::int32_t value);
  /// Sets all of them, or none if one cannot be set: then it returns that one.
  std::optional<msg::VariableId> set_variables(std::span<const msg::AdjVarValue> values);
  /// Stores what is in use in the active profile.
  void save();

  /// Factory parameters for one profile, in the EEPROM and in use; general ones stay as they are.
  /// Precondition: there is one.
  void use_defaults(std::uint8_t profile);
  /// Erases the whole EEPROM, files and user data with it; factory parameters are in use, the first
  /// profile is active.
  void erase();

 private:
  /// A variable that has been set.
  struct Variable {
    std::int32_t given{};
    Optional<std::int32_t> made{};  ///< what the parameters have made of it; nothing without one
  };

  /// Messages that each profile has a copy of; all others are there once.
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
  /// Where the record of a copy begins.
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
  /// What the EEPROM has for one copy, or else the factory parameters.
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
  /// Those that stand for parameters have the parameters' values again.
  void forget_variables();

  Memory& memory_;
  Eeprom eeprom_;
  OneOfEach<StoredMessages> in_use_{};
  std::map<msg::VariableId, Variable> variables_{};  ///< that have been set
};

}  // namespace sbgc::emulator
