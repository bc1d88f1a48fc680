#include "device/parameters/parameters.hpp"

#include <algorithm>

#include <sbgc/meta/variables.hpp>
#include <sbgc/variable_parameters.hpp>

namespace sbgc::emulator {

Parameters::Parameters(Memory& memory, const Availability& versions)
    : memory_(memory), versions_(versions), eeprom_(memory) {
  reload();
}

void Parameters::reload() {
  variables_.clear();
  ParameterMessages::for_each([this]<class M>(Type<M>) { use(stored<M>(copy_in_use<M>())); });
}

std::uint8_t Parameters::profile() const {
  constexpr std::uint8_t profiles = ParametersOf<msg::ReadParams3>::copies;
  return memory_.profile < profiles ? memory_.profile : std::uint8_t{0};
}

void Parameters::select_profile(std::uint8_t profile) {
  if (memory_.is_unsaved || memory_.profile != profile) ++memory_.revision;
  memory_.profile = profile;
  apply_later();
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (is_of_profile<M>) use(stored<M>(profile));
  });
}

std::optional<std::int32_t> Parameters::variable(msg::VariableId id) const {
  if (find_variable(id) == nullptr || !knows(versions_, id)) return std::nullopt;
  const Optional<std::int32_t> now = variable_value(in_use_, id);
  // Another variable may have changed the same parameter meanwhile.
  const auto set = variables_.find(id);
  if (set != variables_.end() && set->second.made == now) return set->second.given;
  return now ? *now : 0;
}

std::uint8_t Parameters::variable_count() const {
  return static_cast<std::uint8_t>(std::count_if(
      std::begin(EnumMeta<msg::VariableId>::values), std::end(EnumMeta<msg::VariableId>::values),
      [this](const ValueInfo& value) { return is_available(value.since, versions_); }));
}

bool Parameters::set_variable(msg::VariableId id, std::int32_t value) {
  const VariableInfo* const known = find_variable(id);
  if (known == nullptr || !knows(versions_, id) || value < known->range.lowest ||
      value > known->range.highest) {
    return false;
  }
  if (variable_value(in_use_, id) && !sbgc::set_variable(in_use_, id, value)) return false;
  variables_[id] = {value, variable_value(in_use_, id)};
  apply_later();
  return true;
}

std::optional<msg::VariableId> Parameters::set_variables(std::span<const msg::AdjVarValue> values) {
  const auto in_use = in_use_;
  const auto variables = variables_;
  const bool is_changed = is_changed_;
  for (const msg::AdjVarValue& one : values) {
    if (set_variable(one.param_id, one.param_value)) continue;
    // Do not set the old values again: they may be out of the variable's range.
    in_use_ = in_use;
    variables_ = variables;
    is_changed_ = is_changed;
    return one.param_id;
  }
  return {};
}

void Parameters::forget_variables() {
  std::erase_if(variables_, [](const auto& entry) { return entry.second.made.has_value(); });
}

void Parameters::save() {
  ParameterMessages::for_each([this]<class M>(Type<M>) {
    // Active parameters were stored or loaded before, so they are not too long.
    if constexpr (is_of_profile<M>) static_cast<void>(store(profile(), of<M>()));
  });
  forget_variables();
}

void Parameters::save(std::span<const msg::VariableId> variables) {
  // The stored parameters, with only these variables changed.
  OneOfEach<ParameterMessages> kept;
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (is_of_profile<M>) kept.template of<M>() = stored<M>(profile());
  });
  for (const msg::VariableId id : variables) {
    const Optional<std::int32_t> value = variable_value(in_use_, id);
    if (value) static_cast<void>(sbgc::set_variable(kept, id, *value));
  }
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (is_of_profile<M>) static_cast<void>(store(profile(), kept.template of<M>()));
  });
}

void Parameters::use_defaults(std::uint8_t profile) {
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (is_of_profile<M>) {
      M defaults = factory<M>(profile);
      share(record<M>(0), defaults);
      static_cast<void>(write(profile, defaults));
    }
  });
}

void Parameters::save_profile_set(std::size_t slot) {
  std::vector<std::uint8_t>& all = memory_.profile_sets[slot];
  all.clear();
  for_each_record([&](std::size_t address) {
    const auto bytes = eeprom_.bytes(address, record_size());
    all.insert(all.end(), bytes.begin(), bytes.end());
  });
  ++memory_.revision;
}

void Parameters::clear_profile_set(std::size_t slot) {
  memory_.profile_sets[slot].clear();
  ++memory_.revision;
}

bool Parameters::load_profile_set(std::size_t slot) {
  std::span<const std::uint8_t> profiles = memory_.profile_sets[slot];
  std::size_t size = 0;
  for_each_record([&](std::size_t) { size += record_size(); });
  if (profiles.size() != size) return false;
  for_each_record([&](std::size_t address) {
    eeprom_.write(address, profiles.first(record_size()));
    profiles = profiles.subspan(record_size());
  });
  memory_.profile_set = static_cast<std::uint8_t>(slot + 1);
  ++memory_.revision;
  reload();
  apply_later();
  return true;
}

void Parameters::erase() {
  eeprom_.erase();
  if (memory_.profile != 0) ++memory_.revision;
  memory_.profile = 0;
  reload();
  apply_later();
}

}  // namespace sbgc::emulator
