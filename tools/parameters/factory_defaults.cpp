#include "parameters/factory_defaults.hpp"

#include <sbgc/messages/parameters.hpp>

#include "parameters/parameter_messages.hpp"

namespace sbgc::tools {

namespace {

Task<Result<ParameterSet>> read_profile(std::uint8_t profile) {
  ReadOptions reading;
  reading.wanted = [profile](const ParametersId& id) {
    return id.copy == profile && copy_count(id) > 1;
  };
  return tasks::read_parameters(reading);
}

/// True if a block has other parameters in the two sets. State of the board does not count.
bool differ(const ParameterSet& a, const ParameterSet& b) {
  for (const ParametersChange& change : diff(a, b)) {
    if (change.kind == ParametersChange::Kind::changed) return true;
  }
  return false;
}

}  // namespace

Task<Result<void>> use_defaults(std::uint8_t profile, ParameterSet before, CallOptions options) {
  msg::UseDefaults request;
  request.profile_id = profile;
  const Result<void> done = co_await tasks::call(request, confirming(options));
  if (done || done.error().code != ErrorCode::unconfirmed) co_return done;
  const Result<ParameterSet> present = co_await read_profile(profile);
  const bool has_changed = present && differ(before, *present);
  co_return has_changed ? Result<void>() : done;
}

Task<Result<ParameterSet>> find_defaults(std::uint8_t profile, ParameterSet before,
                                         CallOptions options) {
  Result<void> done = co_await use_defaults(profile, before, options);
  if (!done && done.error().code == ErrorCode::unconfirmed) {
    auto parameters = before.get<msg::ReadParams3>(profile);
    if (!parameters) co_return parameters.error();
    parameters->axes.roll.p ^= 1U;
    ParameterSet changed;
    if (const auto put = changed.set(*parameters); !put) co_return put.error();
    WriteOptions writing;
    writing.validate = false;
    const WriteReport report = co_await tasks::write_parameters(changed, writing);
    if (!report) co_return report.outcome.error();
    done = co_await use_defaults(profile, changed, options);
  }
  if (!done) co_return done.error();
  co_return co_await read_profile(profile);
}

}  // namespace sbgc::tools
