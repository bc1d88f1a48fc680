#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include <sbgc/client/variables.hpp>
#include <sbgc/detail/meta_limits.hpp>
#include <sbgc/messages/adjustable_variables.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/meta/adjustable_variables.hpp>
#include <sbgc/text.hpp>

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

}  // namespace

Result<const VariableInfo*> find_variable(std::string_view name) {
  const auto* const found = std::ranges::find(variables, name, &VariableInfo::name);
  if (found != std::end(variables)) return found;
  return ClientError{ErrorCode::not_found, fmt::format("there is no adjustable variable {}{}", name,
                                                       similar_names(name))};
}

double variable_value(const VariableInfo& variable, std::int32_t raw) noexcept {
  return variable.unit.real(raw);
}

Result<std::int32_t> variable_raw(const VariableInfo& variable, double value) {
  const double raw = std::round((value - variable.unit.offset) * variable.unit.denominator /
                                variable.unit.numerator);
  // Written so that NaN fails as well.
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
                          .unit = &variable.unit})};
}

namespace tasks {

Task<Result<std::vector<double>>> get_variables(std::vector<std::string> names) {
  std::vector<const VariableInfo*> wanted;
  for (const std::string& name : names) {
    const Result<const VariableInfo*> found = find_variable(name);
    if (!found) co_return found.error();
    wanted.push_back(*found);
  }
  std::vector<double> result;
  while (result.size() < wanted.size()) {
    const std::span<const VariableInfo* const> rest(
        wanted.begin() + static_cast<std::ptrdiff_t>(result.size()), wanted.end());
    const auto part = rest.first(std::min(most_asked, rest.size()));
    msg::GetAdjVarsVal request;
    for (const VariableInfo* const variable : part) request.param_id.push_back(variable->id);
    const Result<msg::SetAdjVarsVal> answer = co_await call(request);
    if (!answer) co_return answer.error();
    if (answer->params.size() != part.size()) {
      co_return ClientError{ErrorCode::mismatch,
                            fmt::format("requested {} variables, but received {}", part.size(),
                                        answer->params.size())};
    }
    for (std::size_t i = 0; i < part.size(); ++i) {
      const msg::AdjVarValue& value = answer->params[i];
      if (value.param_id != part[i]->id) {
        co_return ClientError{ErrorCode::mismatch,
                              fmt::format("requested {}, but received variable {}", part[i]->name,
                                          static_cast<unsigned>(value.param_id))};
      }
      result.push_back(variable_value(*part[i], value.param_value));
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
  std::vector<msg::AdjVarValue> wanted;
  for (const VariableValue& value : values) {
    const Result<const VariableInfo*> found = find_variable(value.name);
    if (!found) co_return found.error();
    const Result<std::int32_t> raw = variable_raw(**found, value.value);
    if (!raw) co_return raw.error();
    wanted.push_back({(*found)->id, *raw});
  }
  for (std::size_t sent = 0; sent < wanted.size();) {
    msg::SetAdjVarsVal request;
    for (; sent < wanted.size() && request.params.size() < most_set; ++sent) {
      request.params.push_back(wanted[sent]);
    }
    Result<void> done = co_await call(request);
    if (done) continue;
    const std::size_t before = sent - request.params.size();
    if (wanted.size() <= most_set) co_return done;
    co_return detail::during(fmt::format("after {} of {} variables", before, wanted.size()),
                             done.error());
  }
  co_return Result<void>();
}

Task<Result<void>> set_variable(std::string name, double value) {
  std::vector<VariableValue> values(1, VariableValue{std::move(name), value});
  co_return co_await set_variables(std::move(values));
}

Task<Result<void>> save_variables() {
  CallOptions options;
  options.expect_confirmation = true;
  co_return co_await call(msg::SaveParams3{}, options);
}

}  // namespace tasks
}  // namespace sbgc
