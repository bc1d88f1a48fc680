/// The profiles: which one is active, and their names.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/parameters.hpp>

namespace sbgc {

/// The number of profiles of a board.
inline constexpr std::size_t profile_count = decltype(msg::ReadProfileNames::profile_name){}.size();
/// The largest size of a name, in bytes of UTF-8.
inline constexpr std::size_t profile_name_size =
    decltype(msg::ReadProfileNames::profile_name)::value_type::capacity();

/// One name for each profile.
struct ProfileNames : std::array<std::string, profile_count> {};

/// Checks whether a profile can have this name; names are never truncated. Errors: `invalid` for
/// too many bytes, invalid UTF-8, or a NUL.
Result<void> check_profile_name(std::string_view name);

namespace tasks {

/// Returns the active profile of the board, counted from 0. Errors: those of Client::call().
Task<Result<std::size_t>> active_profile();

/// Returns the names on the board, without padding. Bytes that are not UTF-8 are kept.
/// Errors: those of Client::call(); `mismatch` if the answers do not agree.
Task<Result<ProfileNames>> profile_names();

/// Renames one profile, counted from 0, and verifies it. The other names stay unchanged, byte for
/// byte. Errors: `invalid` for the profile or the name, and those of write_parameters().
Task<Result<void>> rename_profile(std::size_t profile, std::string name);

/// Renames all profiles and verifies the names. Errors: those of rename_profile().
Task<Result<void>> rename_profiles(ProfileNames names);

}  // namespace tasks
}  // namespace sbgc
