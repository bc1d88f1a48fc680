#include <fmt/format.h>

#include <sbgc/client/client.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/client/profiles.hpp>
#include <sbgc/json_text.hpp>

namespace sbgc {
namespace {

/// Changes the names on the board with `change(message)`.
template <class Change>
Result<void> change_names(Client& client, Change&& change) {
  Result<msg::ReadProfileNames> names = client.call(msg::ReadProfileNamesRequest{});
  if (!names) return names.error();
  change(*names);
  ParameterSet wanted;
  if (Result<void> put = wanted.set(*names); !put) return put;
  return write_parameters(client, wanted).outcome;
}

}  // namespace

Result<void> check_profile_name(std::string_view name) {
  if (name.size() > profile_name_size) {
    return ClientError{ErrorCode::invalid, fmt::format("a profile name has at most {} bytes, this "
                                                       "one has {}",
                                                       profile_name_size, name.size())};
  }
  for (std::string_view rest = name; !rest.empty();) {
    const std::size_t length = detail::utf8_length(rest);
    if (length == 0) {
      return ClientError{ErrorCode::invalid,
                         fmt::format("the profile name is not UTF-8 at its byte {}",
                                     name.size() - rest.size() + 1)};
    }
    if (rest[0] == '\0') {
      return ClientError{ErrorCode::invalid, "a profile name can not hold a NUL character"};
    }
    rest.remove_prefix(length);
  }
  return {};
}

Result<ProfileNames> read_profile_names(Client& client) {
  const Result<msg::ReadProfileNames> names = client.call(msg::ReadProfileNamesRequest{});
  if (!names) return names.error();
  ProfileNames result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto& name = names->profile_name[i];
    result[i].assign(name.data(), name.size());
  }
  return result;
}

Result<void> write_profile_name(Client& client, std::size_t profile, std::string_view name) {
  if (profile >= profile_count) {
    return ClientError{ErrorCode::invalid, fmt::format("there are {} profiles, counted from 0; "
                                                       "there is no profile {}",
                                                       profile_count, profile)};
  }
  if (Result<void> checked = check_profile_name(name); !checked) return checked;
  return change_names(client, [&](msg::ReadProfileNames& names) {
    static_cast<void>(names.profile_name[profile].assign(name));  // its size has been checked
  });
}

Result<void> write_profile_names(Client& client, const ProfileNames& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (Result<void> checked = check_profile_name(names[i]); !checked) {
      return ClientError{checked.error().code,
                         fmt::format("profile {}: {}", i + 1, checked.error().message)};
    }
  }
  return change_names(client, [&](msg::ReadProfileNames& message) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      static_cast<void>(message.profile_name[i].assign(names[i]));  // its size has been checked
    }
  });
}

}  // namespace sbgc
