/// The parameters of the board: of a new one, active, and in the EEPROM.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include <sbgc/emulator/memory.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/adjustable_variables.hpp>
#include <sbgc/meta/parameters.hpp>
#include <sbgc/meta/storage.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/type_list.hpp>
#include <sbgc/types.hpp>
#include <sbgc/validate.hpp>

#include "device/features.hpp"
#include "device/storage/eeprom.hpp"

namespace sbgc::emulator {

void set_factory_values(msg::ReadParams3& out);
void set_factory_values(msg::ReadParamsExt& out);
void set_factory_values(msg::ReadParamsExt2& out);
void set_factory_values(msg::ReadParamsExt3& out);
void set_factory_values(msg::ReadProfileNames& out);
void set_factory_values(msg::ReadExternalData& out);
inline void set_factory_values(msg::ReadAdjVarsCfg&) {}

/// The ParameterMessages of a new board. All values are assumptions: the specification gives none.
/// They suit a typical gimbal with three axes and a battery of four lithium cells, are within all
/// ranges, and only use features of board version 3.0. Reserved bytes are 0.
template <class M>
M factory_parameters(std::uint8_t copy) {
  M out;
  if constexpr (ParametersOf<M>::copies > 1) ParametersOf<M>::copy(out) = copy;
  set_factory_values(out);
  return out;
}

/// Holds one message of each type of a TypeList.
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

/// Parameters are bodies of ParameterMessages. The board uses those of the active profile. Changes
/// of only the active parameters, such as by adjustable variables, differ from the EEPROM until
/// save() or a restart.
///
/// Fields that hold state of the board (FieldRole::state) are stored as received; the handler of a
/// read request fills them in. PROFILE_ID is always the number of the copy.
///
/// General parameters (FieldRole::general) are those in the record of the first copy: writing any
/// copy stores them there and activates them at once.
class Parameters {
 public:
  /// Loads the EEPROM. Factory parameters replace missing or damaged ones, but only as active
  /// parameters, not in the EEPROM.
  explicit Parameters(Memory& memory, const Availability& versions = newest);

  /// Reloads all parameters, as at a restart.
  void reload();

  /// The active profile. An invalid number in the memory counts as 0.
  std::uint8_t profile() const;
  /// Activates the parameters of another profile. Precondition: it exists.
  void select_profile(std::uint8_t profile);

  /// The active parameters.
  template <class M>
  const M& of() const {
    return in_use_.template of<M>();
  }

  /// Returns the parameters that a request reads: the active ones for the active profile, else
  /// those in the EEPROM. Precondition: copy < ParametersOf<M>::copies.
  template <class M>
  M read(std::uint8_t copy) const {
    return copy == copy_in_use<M>() ? of<M>() : stored<M>(copy);
  }
  /// Stores a message in the EEPROM, including reserved bytes and tail, and activates it if it
  /// belongs to the active profile. Returns false if the body is too long for the EEPROM. Same
  /// precondition.
  template <class M>
  bool write(std::uint8_t copy, const M& parameters) {
    M numbered = parameters;
    set_copy(numbered, copy);
    if (!store(copy, numbered)) return false;
    apply_later();
    if (copy == copy_in_use<M>()) {
      use(numbered);
    } else {
      share(numbered, in_use_.template of<M>());
    }
    return true;
  }
  /// Changes some parameters in the EEPROM and the active ones by calling `edit(M&)` for both.
  /// Keeps other unsaved changes. Otherwise like write().
  template <class M, class Edit>
  bool change(std::uint8_t copy, const Edit& edit) {
    auto parameters = stored<M>(copy);
    edit(parameters);
    if (!store(copy, parameters)) return false;
    apply_later();
    auto& in_use = in_use_.template of<M>();
    if (copy == copy_in_use<M>()) {
      edit(in_use);
    } else {
      share(parameters, in_use);
    }
    return true;
  }

  /// Changes active parameters until a restart, a profile change or save().
  template <class M, class Edit>
  void change_in_use(const Edit& edit) {
    edit(in_use_.template of<M>());
    apply_later();
  }

  /// The gimbal and the inputs follow each change at the end of a step of the board. Call this if
  /// something else has changed on which they depend.
  void apply_later() { is_changed_ = true; }
  /// True once after each change.
  bool take_changes() { return std::exchange(is_changed_, false); }

  /// Returns the value of the variable; nothing if this board does not have it.
  std::optional<std::int32_t> variable(msg::VariableId id) const;
  /// The number of variables that this board has.
  std::uint8_t variable_count() const;
  /// Sets a variable until a restart or save(). Returns false if there is no such variable or the
  /// value is out of range. Afterwards variable() returns exactly this value, even if the
  /// parameters can only approximate it.
  bool set_variable(msg::VariableId id, std::int32_t value);
  /// Sets all variables or, if one cannot be set, none; returns that one.
  std::optional<msg::VariableId> set_variables(std::span<const msg::AdjVarValue> values);
  /// Stores the active parameters in the active profile.
  void save();
  /// Stores only these variables. Precondition: the board has them.
  void save(std::span<const msg::VariableId> variables);

  /// Restores the factory parameters of one profile, in the EEPROM and the active ones; keeps
  /// general parameters. Precondition: the profile exists.
  void use_defaults(std::uint8_t profile);
  /// Stores, forgets or loads the parameters of all profiles. load_profile_set() returns false,
  /// without effect, if the slot is empty. Precondition: the slot exists; they count from 0.
  void save_profile_set(std::size_t slot);
  void clear_profile_set(std::size_t slot);
  bool load_profile_set(std::size_t slot);

  /// Erases the whole EEPROM, including files and user data. Activates factory parameters and the
  /// first profile.
  void erase();

 private:
  /// A variable set by a host.
  struct Variable {
    std::int32_t given{};
    Optional<std::int32_t> made{};  ///< the resulting parameter; empty if the variable has none
  };

  /// True if each profile has a copy of the message; otherwise there is one copy.
  template <class M>
  static constexpr bool is_of_profile = (ParametersOf<M>::copies > 1);

  template <class M>
  std::uint8_t copy_in_use() const {
    return is_of_profile<M> ? profile() : std::uint8_t{0};
  }
  template <class M>
  static void set_copy(M& message, std::uint8_t copy) {
    if constexpr (is_of_profile<M>) ParametersOf<M>::copy(message) = copy;
  }
  template <class M>
  static void share([[maybe_unused]] const M& from, [[maybe_unused]] M& to) {
    if constexpr (is_of_profile<M>) ParametersOf<M>::share(from, to);
  }
  /// Returns the address of the record of a copy. Records are in the order of the firmware that
  /// introduced them, so that later ones do not move earlier ones.
  template <class M>
  static std::size_t place(std::uint8_t copy) {
    std::size_t before = 0;
    bool found = false;
    ParameterMessages::for_each([&]<class Other>(Type<Other>) {
      found = found || std::is_same_v<M, Other>;
      const bool is_older = Other::since.firmware < M::since.firmware;
      const bool is_as_old = Other::since.firmware == M::since.firmware;
      if (is_older || (is_as_old && !found)) before += ParametersOf<Other>::copies;
    });
    return layout::parameters + (before + copy) * record_size();
  }
  /// Calls `use(address)` for each record that belongs to a profile.
  template <class Use>
  static void for_each_record(const Use& use) {
    ParameterMessages::for_each([&]<class M>(Type<M>) {
      if constexpr (is_of_profile<M>) {
        for (std::uint8_t copy = 0; copy < ParametersOf<M>::copies; ++copy) use(place<M>(copy));
      }
    });
  }
  template <class M>
  M stored(std::uint8_t copy) const {
    M message = record<M>(copy);
    if (copy != 0) share(record<M>(0), message);
    return message;
  }
  /// Returns the copy in the EEPROM, or factory parameters.
  template <class M>
  M record(std::uint8_t copy) const {
    M message{};
    const auto body = read_record(eeprom_, place<M>(copy), {M::command, copy});
    if (!body || !decode(std::span(*body), message)) message = factory<M>(copy);
    set_copy(message, copy);
    return message;
  }
  /// The factory parameters, limited to those that the firmware knows.
  template <class M>
  M factory(std::uint8_t copy) const {
    M message = factory_parameters<M>(copy);
    limit_to(versions_, message);
    return message;
  }
  template <class M>
  bool store(std::uint8_t copy, const M& message) {
    if (!store_record(copy, message)) return false;
    if (copy == 0) return true;
    const M before = record<M>(0);
    M first = before;
    share(message, first);
    return first == before || store_record(0, first);  // same length as before, so it fits
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
  /// Makes variables that set parameters read those parameters again.
  void forget_variables();

  Memory& memory_;
  Availability versions_;
  Eeprom eeprom_;
  OneOfEach<ParameterMessages> in_use_{};
  std::map<msg::VariableId, Variable> variables_{};  ///< variables that were set
  bool is_changed_{};
};

}  // namespace sbgc::emulator
