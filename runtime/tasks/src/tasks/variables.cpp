#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include <sbgc/client/variables.hpp>
#include <sbgc/internal/find_by.hpp>
#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/messages/adjustable_variables.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/meta/adjustable_variables.hpp>
#include <sbgc/text.hpp>

#include "tasks/agreement.hpp"
#include "tasks/tools.hpp"

namespace sbgc {
namespace {

/// The largest number of variables in one message.
constexpr std::size_t most_set = detail::highest<msg::SetAdjVarsVal>("num_vars");
constexpr std::size_t most_asked = detail::highest<msg::GetAdjVarsVal>("num_vars");

std::string upper_case(std::string_view text) {
  std::string result;
  for (const char c : text) {
    result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return result;
}

/// Returns a hint with names that share a word with this one.
std::string similar_names(std::string_view name) {
  const std::string wanted = upper_case(name);
  const std::string word = wanted.substr(0, wanted.find('_'));
  std::string result;
  for (const VariableInfo& variable : variables) {
    const std::string_view known = variable.name;
    if (known == wanted) return fmt::format("; the name is {}", known);
    const bool is_similar = !word.empty() && known.find(word) != std::string_view::npos;
    if (is_similar)
      result += fmt::format("{}{}", result.empty() ? "; similar names: " : ", ", known);
  }
  return result;
}

const char* name_of(msg::VariableId id) {
  const auto* const found = detail::find_by(variables, id, &VariableInfo::id);
  return found == std::end(variables) ? "a variable" : found->name;
}

}  // namespace

Result<const VariableInfo*> find_variable(std::string_view name) {
  const auto* const found = detail::find_by(variables, name, &VariableInfo::name);
  if (found != std::end(variables)) return found;
  return ClientError{ErrorCode::not_found, fmt::format("there is no adjustable variable {}{}", name,
                                                       similar_names(name))};
}

double variable_value(const VariableInfo& variable, std::int32_t raw,
                      const Availability& versions) noexcept {
  return variable.unit_in(versions).real(raw);
}

Result<std::int32_t> variable_raw(const VariableInfo& variable, double value,
                                  const Availability& versions) {
  const UnitInfo unit = variable.unit_in(versions);
  const double raw = std::round(unit.raw(value));
  // Written such that NaN fails as well.
  if (raw >= variable.range.lowest && raw <= variable.range.highest) {
    return static_cast<std::int32_t>(raw);
  }
  const bool is_high = raw > variable.range.highest;
  return ClientError{
      ErrorCode::invalid,
      to_string(Violation{.path = {nullptr, variable.name},
                          .field = {},
                          .value = raw,
                          .limit = is_high ? variable.range.highest : variable.range.lowest,
                          .rule = is_high ? Rule::maximum : Rule::minimum,
                          .unit = &unit})};
}

namespace tasks {
namespace {

/// Returns the raw values of variables that fit into one message.
Task<Result<std::vector<std::int32_t>>> get_raw(std::vector<msg::VariableId> ids) {
  msg::GetAdjVarsVal request;
  for (const msg::VariableId id : ids) request.param_id.push_back(id);
  const Result<msg::SetAdjVarsVal> answer = co_await call(request);
  if (!answer) co_return answer.error();
  if (answer->params.size() != ids.size()) {
    co_return ClientError{
        ErrorCode::mismatch,
        fmt::format("requested {} variables, but received {}", ids.size(), answer->params.size())};
  }
  std::vector<std::int32_t> values;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const msg::AdjVarValue& value = answer->params[i];
    if (value.param_id != ids[i]) {
      co_return ClientError{ErrorCode::mismatch,
                            fmt::format("requested {}, but received variable {}", name_of(ids[i]),
                                        static_cast<unsigned>(value.param_id))};
    }
    values.push_back(value.param_value);
  }
  co_return values;
}

/// True if the board holds these values, as far as two answers can tell.
Task<Result<bool>> holds(msg::SetAdjVarsVal wanted) {
  std::vector<msg::VariableId> ids;
  std::vector<std::int32_t> values;
  for (const msg::AdjVarValue& value : wanted.params) {
    ids.push_back(value.param_id);
    values.push_back(value.param_value);
  }
  const Result<std::vector<std::int32_t>> present = co_await get_raw(ids);
  if (!present && present.error().code != ErrorCode::mismatch) co_return present.error();
  if (present && *present == values) co_return true;
  const Result<std::vector<std::int32_t>> again = co_await get_raw(ids);
  if (!again) co_return again.error();
  co_return *again == values;
}

/// Sets variables that fit into one message. If an undetected line error may have changed them on
/// the way, reads them back, and sets them once more if they differ.
Task<Result<void>> set_part(msg::SetAdjVarsVal request) {
  const TaskMachine& task = co_await this_task();
  for (unsigned attempts = 2;; --attempts) {
    Result<void> sent = co_await call(request);
    if (!sent || !has_only_sums(task.framing())) co_return sent;
    const Result<bool> is_set = co_await holds(request);
    if (!is_set) co_return detail::during("reading back", is_set.error());
    if (*is_set) co_return Result<void>();
    if (attempts == 1) break;
  }
  co_return ClientError{ErrorCode::mismatch, "the variables read back differently"};
}

}  // namespace

Task<Result<std::vector<double>>> get_variables(std::vector<std::string> names) {
  std::vector<const VariableInfo*> wanted;
  for (const std::string& name : names) {
    const Result<const VariableInfo*> found = find_variable(name);
    if (!found) co_return found.error();
    wanted.push_back(*found);
  }
  const Availability versions = (co_await this_task()).identity().versions();
  std::vector<double> result;
  while (result.size() < wanted.size()) {
    const std::span<const VariableInfo* const> rest(
        wanted.begin() + static_cast<std::ptrdiff_t>(result.size()), wanted.end());
    const auto part = rest.first(std::min(most_asked, rest.size()));
    std::vector<msg::VariableId> ids;
    for (const VariableInfo* const variable : part) ids.push_back(variable->id);
    const Result<std::vector<std::int32_t>> values = co_await get_raw(std::move(ids));
    if (!values) co_return values.error();
    for (std::size_t i = 0; i < part.size(); ++i) {
      result.push_back(variable_value(*part[i], (*values)[i], versions));
    }
  }
  co_return result;
}

Task<Result<double>> get_variable(std::string name) {
  std::vector<std::string> names;
  names.push_back(std::move(name));
  const Result<std::vector<double>> values = co_await get_variables(std::move(names));
  if (!values) co_return values.error();
  co_return values->front();
}

Task<Result<void>> set_variables(std::vector<VariableValue> values) {
  const Availability versions = (co_await this_task()).identity().versions();
  std::vector<msg::AdjVarValue> wanted;
  for (const VariableValue& value : values) {
    const Result<const VariableInfo*> found = find_variable(value.name);
    if (!found) co_return found.error();
    const Result<std::int32_t> raw = variable_raw(**found, value.value, versions);
    if (!raw) co_return raw.error();
    wanted.push_back({(*found)->id, *raw});
  }
  for (std::size_t sent = 0; sent < wanted.size();) {
    msg::SetAdjVarsVal request;
    for (; sent < wanted.size() && request.params.size() < most_set; ++sent) {
      request.params.push_back(wanted[sent]);
    }
    const std::size_t size = request.params.size();
    Result<void> done = co_await set_part(request);
    if (done) continue;
    const std::size_t before = sent - size;
    if (wanted.size() <= most_set) co_return done;
    co_return detail::during(fmt::format("after {} of {} variables", before, wanted.size()),
                             done.error());
  }
  co_return Result<void>();
}

Task<Result<void>> set_variable(std::string name, double value) {
  std::vector<VariableValue> values;
  values.push_back({std::move(name), value});
  co_return co_await set_variables(std::move(values));
}

Task<Result<void>> save_variables() { co_return co_await call(msg::SaveParams3{}, confirming()); }

}  // namespace tasks
}  // namespace sbgc
