/// The names of the profiles.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <sbgc/client/result.hpp>
#include <sbgc/messages/parameters.hpp>

namespace sbgc {

class Client;

inline constexpr std::size_t profile_count = decltype(msg::ReadProfileNames::profile_name){}.size();
/// Most bytes of a name, in UTF-8.
inline constexpr std::size_t profile_name_size =
    decltype(msg::ReadProfileNames::profile_name)::value_type::capacity();

using ProfileNames = std::array<std::string, profile_count>;

/// Why a profile can not be named so: more bytes than fit, not UTF-8, or a NUL inside. Names are
/// never cut.
Result<void> check_profile_name(std::string_view name);

/// The names as the board has them, without the padding. Bytes that are not UTF-8 come as they are.
Result<ProfileNames> read_profile_names(Client& client);

/// Names one profile, counted from 0; the others keep their names to the last byte. Read back.
Result<void> write_profile_name(Client& client, std::size_t profile, std::string_view name);

/// Names all profiles. Read back.
Result<void> write_profile_names(Client& client, const ProfileNames& names);

}  // namespace sbgc
