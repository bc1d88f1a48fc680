#include <functional>

#include <fmt/format.h>

#include <sbgc/client/parameters.hpp>

#include "tasks/agreement.hpp"
#include "tasks/parameters_call.hpp"

namespace sbgc {
namespace detail {

CallOptions parameters_options(const Deadline& deadline) {
  CallOptions options = options_within(deadline);
  options.expect_confirmation = true;
  // Changed fields are validated before. Unchanged values of the board must be writable even if the
  // specification does not allow them.
  options.validate = false;
  return options;
}

Task<Result<Parameters>> read_one(const ParametersKind& kind, std::uint8_t copy,
                                  const Deadline& deadline) {
  const ParametersId id{kind.name(), copy};
  const std::string what = fmt::format("reading {}", to_text(id));
  if (deadline.is_over()) co_return late_error(what);
  Result<std::vector<std::uint8_t>> body = co_await kind.read(copy, parameters_options(deadline));
  if (!body) co_return during(what, body.error());
  if (const std::string problem = kind.problem(*body, copy); !problem.empty()) {
    co_return ClientError{ErrorCode::mismatch, fmt::format("{}: {}", what, problem)};
  }
  co_return Parameters{id, *std::move(body)};
}

Task<Result<Parameters>> read_verified(const ParametersKind& kind, std::uint8_t copy,
                                       const Deadline& deadline, std::vector<Parameters> seen) {
  const auto read = [&] { return read_one(kind, copy, deadline); };
  std::string what = fmt::format("reading {}", to_text({kind.name(), copy}));
  co_return co_await read_until_two_agree<Parameters>(read, std::move(what), std::move(seen));
}

}  // namespace detail

namespace tasks {

Task<Result<ParameterSet>> read_parameters(ReadOptions options) {
  const TaskMachine& machine = co_await this_task();
  const detail::Deadline deadline(machine, options.timeout);
  std::vector<ParametersId> wanted = detail::readable_parameters(machine.identity().versions());
  if (options.wanted) std::erase_if(wanted, std::not_fn(options.wanted));
  const std::size_t total = wanted.size();
  const std::string task = "reading the parameters";
  ParameterSet result;
  for (const ParametersId& id : wanted) {
    const std::string what = to_text(id);
    const Progress progress{result.all().size(), total, what};
    const auto going = detail::go_on(task, options.progress, progress, deadline);
    if (!going) co_return going.error();
    const detail::ParametersKind& kind = *detail::find_parameters_kind(id.message);
    Result<Parameters> block = co_await detail::read_verified(kind, id.copy, deadline);
    if (!block) co_return block.error();
    if (const auto done = result.put(*std::move(block)); !done) co_return done.error();
  }
  const Progress end{total, total, "all parameters are read"};
  const auto done = detail::go_on(task, options.progress, end, deadline);
  if (!done) co_return done.error();
  co_return result;
}

}  // namespace tasks
}  // namespace sbgc
