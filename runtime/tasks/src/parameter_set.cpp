#include <algorithm>

#include <fmt/format.h>

#include <sbgc/client/parameters.hpp>
#include <sbgc/internal/find_by.hpp>

#include "parameters_kind.hpp"

namespace sbgc {

using detail::ParametersKind;

namespace {

std::string change_text(const FieldChange& change) {
  const auto side = [](const std::string& raw, const std::string& meaning) {
    if (raw.empty()) return std::string("nothing");
    return meaning.empty() ? raw : fmt::format("{} ({})", raw, meaning);
  };
  return fmt::format("  {}: {} -> {}\n", change.path, side(change.before, change.before_meaning),
                     side(change.after, change.after_meaning));
}

}  // namespace

std::string to_text(const ParametersId& id) {
  const ParametersKind* const kind = detail::find_parameters_kind(id.message);
  const bool has_copies = kind != nullptr && kind->copies > 1;
  return has_copies || id.copy != 0 ? fmt::format("{} of profile {}", id.message, id.copy + 1)
                                    : id.message;
}

std::string to_text(const std::vector<ParametersId>& ids) {
  std::string result;
  for (const ParametersId& id : ids) result += (result.empty() ? "" : ", ") + to_text(id);
  return result;
}

const Parameters* ParameterSet::find(const ParametersId& id) const noexcept {
  const auto found = detail::find_by(blocks_, id, &Parameters::id);
  return found != blocks_.end() ? &*found : nullptr;
}

Result<void> ParameterSet::put(Parameters block) {
  const ParametersKind* const kind = detail::find_parameters_kind(block.id.message);
  if (kind == nullptr) {
    return ClientError{ErrorCode::invalid,
                       fmt::format("no message {} holds parameters", block.id.message)};
  }
  const std::string problem = kind->problem(block.body, block.id.copy);
  if (!problem.empty()) {
    return ClientError{ErrorCode::invalid, fmt::format("{}: {}", to_text(block.id), problem)};
  }
  const auto found = detail::find_by(blocks_, block.id, &Parameters::id);
  if (found != blocks_.end()) {
    *found = std::move(block);
  } else {
    blocks_.push_back(std::move(block));
  }
  return {};
}

ClientError ParameterSet::missing(const ParametersId& id) {
  return {ErrorCode::not_found, fmt::format("the set has no {}", to_text(id))};
}

std::vector<ParametersChange> diff(const ParameterSet& before, const ParameterSet& after,
                                   const Availability& versions_before,
                                   const Availability& versions_after) {
  using Kind = ParametersChange::Kind;
  std::vector<ParametersChange> changes;
  for (const Parameters& block : before.all()) {
    const Parameters* const other = after.find(block.id);
    if (other == nullptr) {
      changes.push_back({block.id, Kind::only_before, {}});
      continue;
    }
    const ParametersKind& kind = *detail::find_parameters_kind(block.id.message);
    auto fields =
        detail::field_changes(kind, block.body, other->body, versions_before, versions_after);
    if (!fields.empty()) changes.push_back({block.id, Kind::changed, std::move(fields)});
  }
  for (const Parameters& block : after.all()) {
    if (before.find(block.id) == nullptr) changes.push_back({block.id, Kind::only_after, {}});
  }
  return changes;
}

std::string to_text(const std::vector<ParametersChange>& changes) {
  std::string result;
  for (const ParametersChange& change : changes) {
    result += to_text(change.id);
    switch (change.kind) {
      case ParametersChange::Kind::changed: result += ":\n"; break;
      case ParametersChange::Kind::only_before: result += ": removed\n"; break;
      case ParametersChange::Kind::only_after: result += ": added\n"; break;
    }
    for (const FieldChange& field : change.fields) result += change_text(field);
  }
  return result;
}

const char* name(ParametersState state) noexcept {
  switch (state) {
    case ParametersState::equal: return "equal";
    case ParametersState::written: return "written";
    case ParametersState::unwritten: return "unwritten";
    case ParametersState::different: return "different";
    case ParametersState::unknown: return "unknown";
  }
  return "unknown_state";
}

std::string to_text(const WriteReport& report) {
  std::string result =
      report.outcome ? "done\n" : fmt::format("failed: {}\n", report.outcome.error().message);
  for (const ParametersReport& block : report.parameters) {
    result += fmt::format("{}: {}\n", to_text(block.id), name(block.state));
    const bool is_as_wanted =
        block.state == ParametersState::equal || block.state == ParametersState::written;
    if (is_as_wanted) continue;
    const auto& fields = block.deviation.empty() ? block.wanted : block.deviation;
    for (const FieldChange& field : fields) result += change_text(field);
  }
  return result;
}

}  // namespace sbgc
