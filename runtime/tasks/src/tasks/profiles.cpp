#include <fmt/format.h>

#include <sbgc/client/parameters.hpp>
#include <sbgc/client/profiles.hpp>
#include <sbgc/json/values.hpp>
#include <sbgc/text/status.hpp>

#include "parameters_kind.hpp"
#include "tasks/agreement.hpp"
#include "tasks/tools.hpp"

namespace sbgc {
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
                         fmt::format("the profile name is not valid UTF-8 at byte {}",
                                     name.size() - rest.size() + 1)};
    }
    if (rest[0] == '\0') {
      return ClientError{ErrorCode::invalid, "a profile name cannot contain a NUL character"};
    }
    rest.remove_prefix(length);
  }
  return {};
}

namespace tasks {
namespace {

Task<Result<msg::ReadProfileNames>> read_names() {
  co_return co_await detail::call_verified(msg::ReadProfileNamesRequest{},
                                           "reading the profile names");
}

/// Changes the names on the board with `change(message)`.
template <class Change>
Task<Result<void>> change_names(Change change) {
  Result<msg::ReadProfileNames> names = co_await read_names();
  if (!names) co_return names.error();
  change(*names);
  ParameterSet wanted;
  if (const Result<void> put = wanted.set(*names); !put) co_return put;
  const WriteReport report = co_await write_parameters(std::move(wanted));
  co_return report.outcome;
}

}  // namespace

Task<Result<std::size_t>> active_profile() {
  // Any profile tells which one is active. The reader depends on the board.
  const detail::ParametersKind& kind =
      *detail::find_parameters_kind(ParametersOf<msg::ReadParams3>::name);
  const auto body = co_await kind.read(msg::ReadParams3Request::active_profile, {});
  if (!body) co_return detail::during("reading the active profile", body.error());
  msg::ReadParams3 parameters;
  if (const Status status = decode(std::span(*body), parameters); !status) {
    co_return ClientError{ErrorCode::bad_response,
                          fmt::format("reading the active profile: {}", text(status.code))};
  }
  if (parameters.cur_profile_id >= profile_count) {
    co_return ClientError{
        ErrorCode::bad_response,
        fmt::format("the board reports an active profile {}, counted from 0, but has {}",
                    parameters.cur_profile_id, profile_count)};
  }
  co_return parameters.cur_profile_id;
}

Task<Result<ProfileNames>> profile_names() {
  const Result<msg::ReadProfileNames> names = co_await read_names();
  if (!names) co_return names.error();
  ProfileNames result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto& name = names->profile_name[i];
    result[i].assign(name.data(), name.size());
  }
  co_return result;
}

Task<Result<void>> rename_profile(std::size_t profile, std::string name) {
  if (profile >= profile_count) {
    co_return ClientError{ErrorCode::invalid,
                          fmt::format("there are {} profiles, counted from 0; there is no profile "
                                      "{}",
                                      profile_count, profile)};
  }
  if (const Result<void> checked = check_profile_name(name); !checked) co_return checked;
  co_return co_await change_names([&](msg::ReadProfileNames& names) {
    static_cast<void>(names.profile_name[profile].assign(name));  // the size has been checked
  });
}

Task<Result<void>> rename_profiles(ProfileNames names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (const Result<void> checked = check_profile_name(names[i]); !checked) {
      co_return ClientError{checked.error().code,
                            fmt::format("profile {}: {}", i + 1, checked.error().message)};
    }
  }
  co_return co_await change_names([&](msg::ReadProfileNames& message) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      static_cast<void>(message.profile_name[i].assign(names[i]));  // the size has been checked
    }
  });
}

}  // namespace tasks
}  // namespace sbgc
