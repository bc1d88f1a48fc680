#include "parameters/board_parameters.hpp"

#include <vector>

#include <fmt/format.h>

#include <sbgc/client/profiles.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/terminal_text.hpp"

namespace sbgc::tools {

void add_profile_option(CLI::App& command, ProfileOption& option) {
  command
      .add_option("--profile", option.number,
                  "The profile, counted from 1; by default the active one")
      ->type_name("NUMBER")
      ->check(CLI::Range(1, static_cast<int>(profile_count)).description(""));
}

std::string ChosenProfile::text() const {
  return fmt::format("profile {}{}", index + 1, is_active ? ", which is active" : "");
}

ChosenProfile choose_profile(Client& client, const ProfileOption& option) {
  const auto active = static_cast<std::uint8_t>(value_of(client.active_profile()));
  if (!option.number) return {active, true};
  const auto index = static_cast<std::uint8_t>(*option.number - 1);
  return {index, index == active};
}

ParameterSet read_parameters(Client& client, std::function<bool(const ParametersId&)> wanted) {
  const Interruption interruption;
  ProgressBar bar;
  ReadOptions options{.progress = bar.handler(), .wanted = std::move(wanted)};
  return value_of(client.read_parameters(options));
}

namespace {

std::string side_text(const std::string& raw, const std::string& meaning) {
  if (raw.empty()) return "nothing";
  return meaning.empty() ? raw : meaning;
}

std::string change_line(const FieldChange& change) {
  return fmt::format("  {}: {} -> {}\n", change.path,
                     side_text(change.before, change.before_meaning),
                     side_text(change.after, change.after_meaning));
}

/// Prints the blocks in one state, with a sentence about them.
void print_state(const WriteReport& report, ParametersState state, const char* sentence) {
  std::string names;
  for (const ParametersReport& block : report.parameters) {
    if (block.state != state) continue;
    names += (names.empty() ? "" : ", ") + to_text(block.id);
  }
  if (names.empty()) return;
  remark("{}\n", wrapped(fmt::format("{}: {}", sentence, names), line_width(), 0, 2));
}

}  // namespace

std::string changes_text(const WriteReport& report) {
  std::string result;
  for (const ParametersReport& block : report.parameters) {
    if (block.wanted.empty()) continue;
    result += to_text(block.id) + ":\n";
    for (const FieldChange& change : block.wanted) result += change_line(change);
  }
  return result;
}

std::string changes_text(const std::vector<ParametersChange>& changes) {
  std::string result;
  for (const ParametersChange& change : changes) {
    const bool is_changed = change.kind == ParametersChange::Kind::changed;
    const bool is_removed = change.kind == ParametersChange::Kind::only_before;
    result += to_text(change.id) + (is_changed ? ":\n" : is_removed ? ": removed\n" : ": added\n");
    for (const FieldChange& field : change.fields) result += change_line(field);
  }
  return result;
}

std::size_t change_count(const WriteReport& report) {
  std::size_t count = 0;
  for (const ParametersReport& block : report.parameters) count += block.wanted.size();
  return count;
}

void check_outcome(const WriteReport& report, const std::string& hint) {
  if (report) return;
  bool is_any_sent = false;
  for (const ParametersReport& block : report.parameters) {
    is_any_sent = is_any_sent || (block.state != ParametersState::unwritten &&
                                  block.state != ParametersState::equal);
  }
  if (is_any_sent) {
    remark("The board now holds:\n");
    print_state(report, ParametersState::written, "new values, verified");
    print_state(report, ParametersState::equal, "values that needed no change");
    print_state(report, ParametersState::unwritten, "old values, not written");
    print_state(report, ParametersState::unknown,
                "unknown values, because they were sent but could not be read back");
    print_state(report, ParametersState::different, "values that are neither the old nor the new");
    for (const ParametersReport& block : report.parameters) {
      if (block.state != ParametersState::different) continue;
      for (const FieldChange& change : block.deviation) {
        remark("{}", change_line(change));
      }
    }
  } else {
    remark("Nothing was written.\n");
  }
  ClientError error = report.outcome.error();
  error.message += hint;
  fail(error);
}

}  // namespace sbgc::tools
