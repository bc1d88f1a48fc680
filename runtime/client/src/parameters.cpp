#include <algorithm>

#include <fmt/format.h>

#include <sbgc/client/client.hpp>
#include <sbgc/client/parameters.hpp>

#include "settings_kind.hpp"
#include "task.hpp"

namespace sbgc {

using detail::Body;
using detail::SettingsKind;

namespace {

std::string change_text(const FieldChange& change) {
  const auto side = [](const std::string& raw, const std::string& meaning) {
    if (raw.empty()) return std::string("nothing");
    return meaning.empty() ? raw : fmt::format("{} ({})", raw, meaning);
  };
  return fmt::format("  {}: {} -> {}\n", change.path, side(change.before, change.before_meaning),
                     side(change.after, change.after_meaning));
}

CallOptions settings_options(const Deadline& deadline) {
  CallOptions options = detail::options_within(deadline);
  options.expect_confirmation = true;
  // The fields that change are checked before. What is on the board already has to be written
  // again, whatever the specification says about it.
  options.validate = false;
  return options;
}

/// Reads one block.
Result<Block> read_block(Client& client, const SettingsKind& kind, std::uint8_t copy,
                         const Deadline& deadline) {
  const BlockId id{std::string(kind.name), copy};
  if (deadline.is_over()) return detail::late_error(fmt::format("reading {}", to_text(id)));
  auto body = kind.read(client, copy, settings_options(deadline));
  if (!body) return detail::during(fmt::format("reading {}", to_text(id)), body.error());
  if (const std::string problem = kind.problem(*body, copy); !problem.empty()) {
    return ClientError{ErrorCode::mismatch, fmt::format("reading {}: {}", to_text(id), problem)};
  }
  return Block{id, *std::move(body)};
}

}  // namespace

std::string to_text(const BlockId& id) {
  const SettingsKind* const kind = detail::find_settings_kind(id.message);
  const bool has_copies = kind != nullptr && kind->copies > 1;
  return has_copies || id.copy != 0 ? fmt::format("{} of profile {}", id.message, id.copy + 1)
                                    : id.message;
}

const Block* ParameterSet::find(const BlockId& id) const noexcept {
  const auto found = std::ranges::find(blocks_, id, &Block::id);
  return found != blocks_.end() ? &*found : nullptr;
}

Result<void> ParameterSet::put(Block block) {
  const SettingsKind* const kind = detail::find_settings_kind(block.id.message);
  if (kind == nullptr) {
    return ClientError{ErrorCode::invalid,
                       fmt::format("no message {} holds settings", block.id.message)};
  }
  const std::string problem = kind->problem(block.body, block.id.copy);
  if (!problem.empty()) {
    return ClientError{ErrorCode::invalid, fmt::format("{}: {}", to_text(block.id), problem)};
  }
  const auto found = std::ranges::find(blocks_, block.id, &Block::id);
  if (found != blocks_.end()) {
    *found = std::move(block);
  } else {
    blocks_.push_back(std::move(block));
  }
  return {};
}

ClientError ParameterSet::missing(const BlockId& id) {
  return {ErrorCode::not_found, fmt::format("{} is not among these settings", to_text(id))};
}

std::vector<BlockChange> diff(const ParameterSet& before, const ParameterSet& after) {
  using Kind = BlockChange::Kind;
  std::vector<BlockChange> changes;
  for (const Block& block : before.blocks()) {
    const Block* const other = after.find(block.id);
    if (other == nullptr) {
      changes.push_back({block.id, Kind::only_before, {}});
      continue;
    }
    const SettingsKind& kind = *detail::find_settings_kind(block.id.message);
    auto fields = detail::field_changes(kind, block.body, other->body);
    if (!fields.empty()) changes.push_back({block.id, Kind::changed, std::move(fields)});
  }
  for (const Block& block : after.blocks()) {
    if (before.find(block.id) == nullptr) changes.push_back({block.id, Kind::only_after, {}});
  }
  return changes;
}

std::string to_text(const std::vector<BlockChange>& changes) {
  std::string result;
  for (const BlockChange& change : changes) {
    result += to_text(change.id);
    switch (change.kind) {
      case BlockChange::Kind::changed: result += ":\n"; break;
      case BlockChange::Kind::only_before: result += ": not there any more\n"; break;
      case BlockChange::Kind::only_after: result += ": not there before\n"; break;
    }
    for (const FieldChange& field : change.fields) result += change_text(field);
  }
  return result;
}

Result<ParameterSet> read_parameters(Client& client, const ReadOptions& options) {
  const Deadline deadline(options.clock, options.timeout);
  const Availability versions = client.board().versions();
  std::size_t total = 0;
  for (const SettingsKind& kind : detail::settings_kinds()) {
    if (kind.is_readable(versions)) total += kind.copies;
  }
  const std::string task = "reading the settings";
  ParameterSet result;
  for (const SettingsKind& kind : detail::settings_kinds()) {
    if (!kind.is_readable(versions)) continue;
    for (std::uint8_t copy = 0; copy < kind.copies; ++copy) {
      const std::string what = to_text(BlockId{std::string(kind.name), copy});
      const Progress progress{result.blocks().size(), total, what};
      if (auto going = detail::go_on(task, options.progress, progress, deadline); !going) {
        return going.error();
      }
      Result<Block> block = read_block(client, kind, copy, deadline);
      if (!block) return block.error();
      if (auto done = result.put(*std::move(block)); !done) return done.error();
    }
  }
  const Progress end{total, total, "all settings are read"};
  if (auto done = detail::go_on(task, options.progress, end, deadline); !done) return done.error();
  return result;
}

const char* name(BlockState state) noexcept {
  switch (state) {
    case BlockState::equal: return "equal";
    case BlockState::written: return "written";
    case BlockState::unwritten: return "unwritten";
    case BlockState::different: return "different";
    case BlockState::unknown: return "unknown";
  }
  return "unknown_state";
}

namespace {

/// One block on its way to the board.
struct Step {
  const SettingsKind* kind{};
  std::vector<std::uint8_t> before{};
  std::vector<std::uint8_t> wanted{};  ///< as it has to be written
};

/// write_parameters() as it goes on.
class Writing {
 public:
  Writing(Client& client, const ParameterSet& wanted, const WriteOptions& options)
      : client_(client),
        wanted_(wanted),
        options_(options),
        deadline_(options.clock, options.timeout) {}

  WriteReport run() {
    report_.outcome = prepare();
    if (report_.outcome && !options_.dry_run) report_.outcome = write_all();
    return std::move(report_);
  }

 private:
  /// Reads what is there and looks for everything that can be found wrong beforehand.
  Result<void> prepare() {
    const Availability versions = client_.board().versions();
    for (const Block& block : wanted_.blocks()) {
      report_.blocks.push_back({block.id, BlockState::unwritten, {}, {}});
      steps_.push_back({detail::find_settings_kind(block.id.message), {}, {}});
    }
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      Step& step = steps_[i];
      const Block& block = wanted_.blocks()[i];
      if (!step.kind->is_readable(versions) || !step.kind->is_writable(versions)) {
        return ClientError{ErrorCode::unsupported,
                           fmt::format("this board does not have {}", to_text(block.id))};
      }
      if (auto going = tell(i, to_text(block.id)); !going) return going;
      Result<Block> present = read_block(client_, *step.kind, block.id.copy, deadline_);
      if (!present) return present.error();
      auto body = detail::merged(*step.kind, block.body, present->body);
      if (!body) {
        return ClientError{
            ErrorCode::incompatible,
            fmt::format("{} has {} bytes on this board, {} are wanted: it is another firmware's",
                        to_text(block.id), present->body.size(), block.body.size())};
      }
      step.before = std::move(present->body);
      step.wanted = *std::move(body);
      if (detail::are_equal(*step.kind, step.before, step.wanted)) {
        report_.blocks[i].state = BlockState::equal;
      }
      report_.blocks[i].wanted = detail::field_changes(*step.kind, step.before, step.wanted);
    }
    return options_.validate ? validate(versions) : Result<void>();
  }

  /// Looks at the values of the fields that change.
  Result<void> validate(const Availability& versions) {
    std::string problems;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const BlockReport& block = report_.blocks[i];
      steps_[i].kind->violations(
          steps_[i].wanted, versions, [&](std::string_view path, const std::string& text) {
            if (std::ranges::find(block.wanted, path, &FieldChange::path) == block.wanted.end()) {
              return;
            }
            problems +=
                fmt::format("{}{}, {}", problems.empty() ? "" : "\n", to_text(block.id), text);
          });
      problems += contradiction(i, problems.empty() ? "" : "\n");
    }
    if (problems.empty()) return {};
    return ClientError{ErrorCode::invalid, problems};
  }

  /// What general settings a block wants otherwise than the first block of its kind, each behind
  /// `separator`.
  std::string contradiction(std::size_t index, std::string_view separator) const {
    const Step& step = steps_[index];
    const auto first = std::ranges::find(steps_, step.kind, &Step::kind);
    const BlockId& other = report_.blocks[static_cast<std::size_t>(first - steps_.begin())].id;
    std::string result;
    for (const auto& field : detail::general_changes(*step.kind, first->wanted, step.wanted)) {
      if (is_kept_apart(*first, field.path)) continue;
      result += fmt::format("{}{}, {}: {} is wanted, but {} in {}; it is one for the whole board",
                            separator, to_text(report_.blocks[index].id), field.path, field.after,
                            field.before, to_text(other));
      separator = "\n";
    }
    return result;
  }

  /// Whether the board has several values of a general setting: then it is not general there.
  bool is_kept_apart(const Step& first, std::string_view path) const {
    return std::ranges::any_of(steps_, [&](const Step& step) {
      if (step.kind != first.kind) return false;
      const auto fields = detail::general_changes(*step.kind, first.before, step.before);
      return std::ranges::find(fields, path, &FieldChange::path) != fields.end();
    });
  }

  Result<void> write_all() {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (report_.blocks[i].state == BlockState::equal) continue;
      auto going = tell(steps_.size() + i, to_text(report_.blocks[i].id));
      if (!going) return stop(i, std::move(going));
      if (auto done = write(i); !done) return stop(i + 1, std::move(done));
    }
    return check_all();
  }

  /// Ends it early, with blocks in front of `end` sent: their general settings are the same in
  /// other blocks, so what these say now has to be read.
  Result<void> stop(std::size_t end, Result<void> why) {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const auto changes_it = [&](const Step& sent) {
        return sent.kind == steps_[i].kind && &sent != &steps_[i] &&
               !detail::general_changes(*sent.kind, sent.before, sent.wanted).empty();
      };
      if (!std::any_of(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(end),
                       changes_it)) {
        continue;
      }
      if (!look(i)) report_.blocks[i].state = BlockState::unknown;
    }
    return why;
  }

  Result<void> write(std::size_t index) {
    const Step& step = steps_[index];
    BlockReport& block = report_.blocks[index];
    const Result<void> sent = step.kind->write(client_, step.wanted, settings_options(deadline_));
    // Whatever the answer, or if there was none: only what can be read back is known.
    if (auto seen = look(index); !seen) {
      block.state = BlockState::unknown;
      return sent ? seen : detail::during("writing " + to_text(block.id), sent.error());
    }
    if (!sent) return detail::during("writing " + to_text(block.id), sent.error());
    if (block.state == BlockState::written) return {};
    return ClientError{ErrorCode::mismatch,
                       fmt::format("{} was confirmed, but reading it back gives something else",
                                   to_text(block.id))};
  }

  /// Reads a block back and notes what is there.
  Result<void> look(std::size_t index) {
    const Step& step = steps_[index];
    BlockReport& block = report_.blocks[index];
    Result<Block> present = read_block(client_, *step.kind, block.id.copy, deadline_);
    if (!present) return present.error();
    const bool was_equal = detail::are_equal(*step.kind, step.before, step.wanted);
    block.deviation.clear();
    if (detail::are_equal(*step.kind, present->body, step.wanted)) {
      block.state = was_equal ? BlockState::equal : BlockState::written;
    } else if (detail::are_equal(*step.kind, present->body, step.before)) {
      block.state = BlockState::unwritten;
    } else {
      block.state = BlockState::different;
    }
    if (block.state == BlockState::different || block.state == BlockState::unwritten) {
      block.deviation = detail::field_changes(*step.kind, step.wanted, present->body);
    }
    return {};
  }

  /// Reads all blocks once more: writing one may have changed another.
  Result<void> check_all() {
    const bool any = std::ranges::any_of(
        report_.blocks, [](const BlockReport& b) { return b.state == BlockState::written; });
    std::string wrong;
    for (std::size_t i = 0; any && i < steps_.size(); ++i) {
      auto going = tell(2 * steps_.size() + i, to_text(report_.blocks[i].id));
      if (!going) return stop(steps_.size(), std::move(going));
      if (auto seen = look(i); !seen) {
        // What is still to be looked at may have been changed by what was written since.
        for (std::size_t rest = i; rest < steps_.size(); ++rest) {
          report_.blocks[rest].state = BlockState::unknown;
        }
        return seen;
      }
      const BlockState state = report_.blocks[i].state;
      if (state != BlockState::equal && state != BlockState::written) {
        wrong += fmt::format("{}{}", wrong.empty() ? "" : ", ", to_text(report_.blocks[i].id));
      }
    }
    if (!wrong.empty()) {
      return ClientError{ErrorCode::mismatch,
                         "in the end, something else than was wanted is read for " + wrong};
    }
    const std::size_t total = 3 * steps_.size();
    if (options_.progress) options_.progress({total, total, "all settings are written"});
    return {};
  }

  Result<void> tell(std::size_t done, const std::string& what) const {
    const std::size_t passes = options_.dry_run ? 1 : 3;
    const Progress progress{done, passes * steps_.size(), what};
    return detail::go_on("writing the settings", options_.progress, progress, deadline_);
  }

  Client& client_;
  const ParameterSet& wanted_;
  const WriteOptions& options_;
  Deadline deadline_;
  std::vector<Step> steps_{};
  WriteReport report_{};
};

}  // namespace

std::string to_text(const WriteReport& report) {
  std::string result =
      report.outcome ? "done\n" : fmt::format("failed: {}\n", report.outcome.error().message);
  for (const BlockReport& block : report.blocks) {
    result += fmt::format("{}: {}\n", to_text(block.id), name(block.state));
    const bool is_as_wanted =
        block.state == BlockState::equal || block.state == BlockState::written;
    if (is_as_wanted) continue;
    const auto& fields = block.deviation.empty() ? block.wanted : block.deviation;
    for (const FieldChange& field : fields) result += change_text(field);
  }
  return result;
}

WriteReport write_parameters(Client& client, const ParameterSet& wanted,
                             const WriteOptions& options) {
  return Writing(client, wanted, options).run();
}

}  // namespace sbgc
