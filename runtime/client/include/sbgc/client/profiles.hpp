/// The names of the profiles.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/parameters.hpp>

namespace sbgc {

inline constexpr std::size_t profile_count = decltype(msg::ReadProfileNames::profile_name){}.size();
/// Most bytes of a name, in UTF-8.
inline constexpr std::size_t profile_name_size =
    decltype(msg::ReadProfileNames::profile_name)::value_type::capacity();

/// One name for each profile.
struct ProfileNames : std::array<std::string, profile_count> {};

/// Why a profile cannot have this name: more bytes than fit, not UTF-8, or a NUL inside. Names are
/// never cut.
Result<void> check_profile_name(std::string_view name);

namespace tasks {

/// The names as the board has them, without the padding. Bytes that are not UTF-8 come as they are.
Task<Result<ProfileNames>> profile_names();

/// Names one profile, counted from 0; the others keep their names to the last byte. Read back.
Task<Result<void>> rename_profile(std::size_t profile, std::string name);

/// Names all profiles. Read back.
Task<Result<void>> rename_profiles(ProfileNames names);

}  // namespace tasks
}  // namespace sbgc
