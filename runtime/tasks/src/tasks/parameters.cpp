#include "tasks/parameters.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include <sbgc/client/parameters.hpp>
#include <sbgc/internal/find_by.hpp>
#include <sbgc/text.hpp>

#include "tasks/agreement.hpp"

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

using detail::ParametersKind;

namespace {

/// The longest time for a write and its confirmation. With less time left, it is not started:
/// "unwritten" is better than "unknown".
constexpr std::chrono::milliseconds writing_time{250};

/// A block to be written.
struct Step {
  const ParametersKind* kind{};
  std::vector<std::uint8_t> before{};
  std::vector<std::uint8_t> wanted{};  ///< with the state of the board merged in
};

/// Returns the paths of the responsible values: that of the violation, and of the field that it
/// must not exceed.
std::vector<std::string> paths_of(const Violation& violation) {
  std::vector<std::string> paths{to_string(violation.path)};
  if (violation.other == nullptr) return paths;
  std::string other = paths.front();
  const std::size_t at = other.rfind(violation.field.name);
  other.replace(at, std::string_view(violation.field.name).size(), violation.other->name);
  paths.push_back(std::move(other));
  return paths;
}

/// The state of a running write_parameters().
class Writing {
 public:
  Writing(const TaskMachine& task, const ParameterSet& wanted, const WriteOptions& options)
      : task_(task), wanted_(wanted), options_(options), deadline_(task, options.timeout) {}

  Task<WriteReport> run() {
    report_.outcome = co_await prepare();
    if (report_.outcome && !options_.dry_run) report_.outcome = co_await write_all();
    co_return std::move(report_);
  }

 private:
  /// Reads the current parameters and checks everything that can be checked in advance.
  Task<Result<void>> prepare() {
    const Availability versions = this->versions();
    for (const Parameters& block : wanted_.all()) {
      report_.parameters.push_back({block.id, ParametersState::unwritten, {}, {}});
      steps_.push_back({detail::find_parameters_kind(block.id.message), {}, {}});
    }
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      Step& step = steps_[i];
      const Parameters& block = wanted_.all()[i];
      if (!step.kind->is_readable(versions) || !step.kind->is_writable(versions)) {
        co_return ClientError{ErrorCode::unsupported,
                              fmt::format("this board does not have {}", to_text(block.id))};
      }
      if (auto going = tell(i, to_text(block.id)); !going) co_return going;
      const Result<Parameters> present = co_await read(i, block.body);
      if (!present) co_return present.error();
      auto body = detail::merged(*step.kind, block.body, present->body);
      if (!body) {
        co_return ClientError{
            ErrorCode::incompatible,
            fmt::format(
                "{} has {} bytes on this board, but {} in the set, which is of another firmware",
                to_text(block.id), present->body.size(), block.body.size())};
      }
      step.before = present->body;
      step.wanted = *std::move(body);
      if (detail::are_equal(*step.kind, step.before, step.wanted)) {
        report_.parameters[i].state = ParametersState::equal;
      }
      report_.parameters[i].wanted =
          detail::field_changes(*step.kind, step.before, step.wanted, versions, versions);
    }
    co_return options_.validate ? validate(versions) : Result<void>();
  }

  /// Reads a block of the board. If it differs from the expected body and the line may have changed
  /// it, it is read once more: it determines what is written and reported.
  Task<Result<Parameters>> read(std::size_t index, detail::Body expected) {
    const detail::ParametersKind& kind = *steps_[index].kind;
    const std::uint8_t copy = report_.parameters[index].id.copy;
    Result<Parameters> present = co_await detail::read_one(kind, copy, deadline_);
    if (present && detail::are_equal(kind, present->body, expected)) co_return present;
    if (!present && present.error().code != ErrorCode::mismatch) co_return present;
    std::vector<Parameters> seen;
    if (present) seen.push_back(*std::move(present));
    if (!seen.empty() && !has_only_sums(task_.framing())) co_return std::move(seen.front());
    co_return co_await detail::read_verified(kind, copy, deadline_, std::move(seen));
  }

  /// Validates the fields that change.
  Result<void> validate(const Availability& versions) {
    std::string problems;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const ParametersReport& block = report_.parameters[i];
      const AnyMessage message = steps_[i].kind->message(steps_[i].wanted);
      message.validate(versions, [&](const Violation& violation) {
        const std::vector<std::string> paths = paths_of(violation);
        const auto is_to_blame = [&](const FieldChange& change) {
          return std::find(paths.begin(), paths.end(), change.path) != paths.end();
        };
        if (std::none_of(block.wanted.begin(), block.wanted.end(), is_to_blame)) return;
        problems += fmt::format("{}{}, {}", problems.empty() ? "" : "\n", to_text(block.id),
                                to_string(violation));
      });
      problems += contradiction(i, problems.empty() ? "" : "\n");
    }
    if (problems.empty()) return {};
    return ClientError{ErrorCode::invalid, problems};
  }

  Availability versions() const { return task_.identity().versions(); }

  /// Returns the general parameters in which a block differs from the first block of its kind, each
  /// after a `separator`.
  std::string contradiction(std::size_t index, std::string_view separator) const {
    const Step& step = steps_[index];
    const auto first = detail::find_by(steps_, step.kind, &Step::kind);
    const ParametersId& other =
        report_.parameters[static_cast<std::size_t>(first - steps_.begin())].id;
    std::string result;
    for (const auto& field :
         detail::general_changes(*step.kind, first->wanted, step.wanted, versions())) {
      if (is_kept_apart(*first, field.path)) continue;
      result += fmt::format("{}{}, {}: {} is wanted, but {} in {}; the board has only one value",
                            separator, to_text(report_.parameters[index].id), field.path,
                            field.after, field.before, to_text(other));
      separator = "\n";
    }
    return result;
  }

  /// True if the board holds different values of a general parameter, so it is not general there.
  bool is_kept_apart(const Step& first, std::string_view path) const {
    return std::any_of(steps_.begin(), steps_.end(), [&](const Step& step) {
      if (step.kind != first.kind) return false;
      const auto fields =
          detail::general_changes(*step.kind, first.before, step.before, versions());
      return detail::find_by(fields, path, &FieldChange::path) != fields.end();
    });
  }

  Task<Result<void>> write_all() {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (report_.parameters[i].state == ParametersState::equal) continue;
      auto going = tell(steps_.size() + i, to_text(report_.parameters[i].id));
      if (going && deadline_.left() < writing_time) {
        going = detail::late_error("writing the parameters");
      }
      if (!going) co_return co_await stop(i, std::move(going));
      if (auto done = co_await write(i); !done) co_return co_await stop(i + 1, std::move(done));
    }
    co_return co_await check_all();
  }

  /// Ends the operation early. Blocks before `end` were sent, and their general parameters also
  /// appear in other blocks, so reads those again.
  Task<Result<void>> stop(std::size_t end, Result<void> why) {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const auto changes_it = [&](const Step& sent) {
        return sent.kind == steps_[i].kind && &sent != &steps_[i] &&
               !detail::general_changes(*sent.kind, sent.before, sent.wanted, versions()).empty();
      };
      if (!std::any_of(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(end),
                       changes_it)) {
        continue;
      }
      if (!co_await look(i)) report_.parameters[i].state = ParametersState::unknown;
    }
    co_return why;
  }

  Task<Result<void>> write(std::size_t index) {
    const ParametersState& state = report_.parameters[index].state;
    Result<void> done = co_await write_once(index);
    // The line may have changed the request, or lost it: do not leave the board with such values.
    const bool may_be_damaged =
        state == ParametersState::different && has_only_sums(task_.framing());
    const bool is_lost = state == ParametersState::unwritten && is_unconfirmed_;
    const bool has_time = deadline_.left() >= writing_time;
    if (!done && has_time && (may_be_damaged || is_lost)) done = co_await write_once(index);
    co_return done;
  }

  Task<Result<void>> write_once(std::size_t index) {
    const Step& step = steps_[index];
    ParametersReport& block = report_.parameters[index];
    const Result<bool> sent =
        co_await step.kind->write(step.wanted, detail::parameters_options(deadline_));
    is_unconfirmed_ = sent && !*sent;
    // Regardless of the response: only the values read back are certain.
    if (auto seen = co_await look(index); !seen) {
      block.state = ParametersState::unknown;
      co_return sent ? seen : detail::during("writing " + to_text(block.id), sent.error());
    }
    if (!sent) co_return detail::during("writing " + to_text(block.id), sent.error());
    if (block.state == ParametersState::written) co_return Result<void>();
    co_return ClientError{
        ErrorCode::mismatch,
        fmt::format("the board {} {}, {} it reads back {}",
                    is_unconfirmed_ ? "did not confirm" : "confirmed", to_text(block.id),
                    is_unconfirmed_ ? "and" : "but",
                    block.state == ParametersState::unwritten ? "as before" : "differently")};
  }

  /// Reads a block back and records its state.
  Task<Result<void>> look(std::size_t index) {
    const Step& step = steps_[index];
    ParametersReport& block = report_.parameters[index];
    const Result<Parameters> present = co_await read(index, step.wanted);
    if (!present) co_return present.error();
    const bool was_equal = detail::are_equal(*step.kind, step.before, step.wanted);
    block.deviation.clear();
    if (detail::are_equal(*step.kind, present->body, step.wanted)) {
      block.state = was_equal ? ParametersState::equal : ParametersState::written;
    } else if (detail::are_equal(*step.kind, present->body, step.before)) {
      block.state = ParametersState::unwritten;
    } else {
      block.state = ParametersState::different;
    }
    if (block.state == ParametersState::different || block.state == ParametersState::unwritten) {
      block.deviation =
          detail::field_changes(*step.kind, step.wanted, present->body, versions(), versions());
    }
    co_return Result<void>();
  }

  /// Reads all blocks again, because writing one may have changed another.
  Task<Result<void>> check_all() {
    const bool any =
        std::any_of(report_.parameters.begin(), report_.parameters.end(),
                    [](const ParametersReport& b) { return b.state == ParametersState::written; });
    std::string wrong;
    for (std::size_t i = 0; any && i < steps_.size(); ++i) {
      auto going = tell(2 * steps_.size() + i, to_text(report_.parameters[i].id));
      if (!going) co_return co_await stop(steps_.size(), std::move(going));
      if (auto seen = co_await look(i); !seen) {
        // Blocks not read yet may have been changed by later writes.
        for (std::size_t rest = i; rest < steps_.size(); ++rest) {
          report_.parameters[rest].state = ParametersState::unknown;
        }
        co_return seen;
      }
      const ParametersState state = report_.parameters[i].state;
      if (state != ParametersState::equal && state != ParametersState::written) {
        wrong += fmt::format("{}{}", wrong.empty() ? "" : ", ", to_text(report_.parameters[i].id));
      }
    }
    if (!wrong.empty()) {
      co_return ClientError{ErrorCode::mismatch,
                            "the final check read unexpected values of " + wrong};
    }
    const std::size_t total = 3 * steps_.size();
    if (options_.progress) options_.progress({total, total, "all parameters are written"});
    co_return Result<void>();
  }

  Result<void> tell(std::size_t done, const std::string& what) const {
    const std::size_t passes = options_.dry_run ? 1 : 3;
    const Progress progress{done, passes * steps_.size(), what};
    return detail::go_on("writing the parameters", options_.progress, progress, deadline_);
  }

  const TaskMachine& task_;
  const ParameterSet& wanted_;
  const WriteOptions& options_;
  detail::Deadline deadline_;
  std::vector<Step> steps_{};
  bool is_unconfirmed_ = false;  ///< the last write, although the board could have confirmed it
  WriteReport report_{};
};

}  // namespace

namespace tasks {

Task<WriteReport> write_parameters(ParameterSet wanted, WriteOptions options) {
  Writing writing(co_await this_task(), wanted, options);
  co_return co_await writing.run();
}

}  // namespace tasks

}  // namespace sbgc
