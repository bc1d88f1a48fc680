#include "gateway/parameter_tasks.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include <sbgc/client/parameters.hpp>
#include <sbgc/client/profiles.hpp>
#include <sbgc/internal/words.hpp>

#include "values/field_lookup.hpp"

namespace sbgc::tools {

namespace {

Task<Result<std::uint8_t>> chosen_profile(std::optional<std::uint8_t> wanted) {
  if (wanted) co_return *wanted;
  Result<std::size_t> active = co_await tasks::active_profile();
  if (!active) co_return active.error();
  co_return static_cast<std::uint8_t>(*active);
}

/// Adds the values of a block that a name denotes.
void add_shown(Json& list, const FoundParameters& found, const Parameters& block,
               const Availability& versions) {
  const std::vector<ShownParameter> all = shown_parameters(block, versions);
  for (const FoundField& field : found.fields) {
    const std::string path = steps_text(field.steps);
    for (const ShownParameter& parameter : all) {
      if (detail::is_in_field(parameter.path, path)) list.push_back(to_json(parameter));
    }
  }
}

/// Returns the copy of the block that a name denotes: blocks shared by profiles have one.
std::uint8_t copy_of(const FoundParameters& one, std::uint8_t profile) {
  return one.message->copies == 1 ? std::uint8_t{0} : profile;
}

Json changes_of(const WriteReport& report) {
  Json changes = Json::array();
  for (const ParametersReport& block : report.parameters) {
    for (const FieldChange& change : block.wanted) {
      changes.push_back({{"parameters", to_text(block.id)},
                         {"path", change.path},
                         {"before", change.before},
                         {"after", change.after}});
    }
  }
  return changes;
}

}  // namespace

Task<Result<Json>> get_parameters(GetOrder order) {
  const Result<std::uint8_t> profile = co_await chosen_profile(order.profile);
  if (!profile) co_return profile.error();
  ReadOptions options;
  options.wanted = [&](const ParametersId& id) {
    return std::ranges::any_of(order.parameters, [&](const FoundParameters& one) {
      return id == ParametersId{one.message->type->info->name, copy_of(one, *profile)};
    });
  };
  const Result<ParameterSet> set = co_await tasks::read_parameters(options);
  if (!set) co_return set.error();
  const Availability versions = (co_await tasks::this_task()).identity().versions();
  Json list = Json::array();
  for (const FoundParameters& one : order.parameters) {
    const char* const name = one.message->type->info->name;
    const Parameters* const block = set->find({name, copy_of(one, *profile)});
    if (block == nullptr) {
      co_return ClientError{ErrorCode::unsupported,
                            fmt::format("this board does not have {}", name)};
    }
    add_shown(list, one, *block, versions);
  }
  co_return Json{{"profile", *profile + 1}, {"parameters", std::move(list)}};
}

Task<Result<Json>> set_parameters(SetOrder order) {
  const Result<std::uint8_t> profile = co_await chosen_profile(order.profile);
  if (!profile) co_return profile.error();
  ReadOptions options;
  options.wanted = [&](const ParametersId& id) {
    return std::ranges::any_of(
        order.values, [&](const MessageValues& one) { return concerns(one, id, *profile); });
  };
  const Result<ParameterSet> present = co_await tasks::read_parameters(options);
  if (!present) co_return present.error();
  const Availability versions = (co_await tasks::this_task()).identity().versions();
  ParameterSet wanted;
  std::string problem;
  try {
    wanted = with_values(*present, order.values, *profile, versions);
  } catch (const std::runtime_error& error) {
    problem = error.what();
  }
  if (!problem.empty()) co_return ClientError{ErrorCode::invalid, problem};
  const WriteOptions write;
  const WriteReport report = co_await tasks::write_parameters(wanted, write);
  if (!report) co_return report.outcome.error();
  co_return Json{{"profile", *profile + 1}, {"changes", changes_of(report)}};
}

}  // namespace sbgc::tools
