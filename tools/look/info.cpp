// sbgc info: a gimbal, its line, and the features that it does not support.

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/any.hpp>
#include <sbgc/availability.hpp>
#include <sbgc/explain.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/meta/all.hpp>

#include "board/connection.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

struct InfoOptions {
  std::string format = "text";
  bool all = false;
};

/// The response times of a line.
struct LineTest {
  unsigned sent = 0;
  std::vector<double> times_ms{};  // of the responses, sorted

  double median() const { return times_ms[times_ms.size() / 2]; }
};

/// A flag that some boards have.
struct Feature {
  const ValueInfo* info{};
  bool is_present{};
};

struct Info {
  BoardIdentity board{};
  std::string line{};
  ClientStatistics statistics{};
  double open_s{};  // since the line was opened
  LineTest test{};
  std::vector<Feature> features{};
  std::vector<Feature> states{};
  std::vector<std::string> unsupported{};  // commands to the board
};

LineTest test_line(Client& client) {
  constexpr unsigned requests = 20;
  LineTest test{.sent = requests};
  for (unsigned i = 0; i < requests; ++i) {
    const auto start = Clock::now();
    if (!client.call(roles::IntroductionRequest{}, {.retries = 0})) continue;
    test.times_ms.push_back(Milliseconds(Clock::now() - start).count());
  }
  std::ranges::sort(test.times_ms);
  return test;
}

template <class E>
void add_flags(Flags<E> flags, std::vector<Feature>& features) {
  for (const ValueInfo& value : EnumMeta<E>::info.values) {
    features.push_back({&value, flags.has(static_cast<E>(value.value))});
  }
}

/// Returns the commands of which these versions support no form.
std::vector<std::string> unsupported_commands(const Availability& versions) {
  std::vector<std::string> all;
  std::vector<std::string> known;
  for (const MessageType* const type : message_types()) {
    const MessageInfo& info = *type->info;
    if (!type->is_sent_to_board() || info.effects.has(Effect::unknown)) continue;
    if (std::ranges::find(all, info.command) == all.end()) all.emplace_back(info.command);
    if (objection_to(info, versions).empty()) known.emplace_back(info.command);
  }
  std::erase_if(all, [&](const auto& one) { return std::ranges::find(known, one) != known.end(); });
  return all;
}

Info collect(const CommandContext& context) {
  const auto start = Clock::now();
  Client client = connect(context.gimbal);
  Info info{.board = client.identity(),
            .line = line_to_gimbal(client.description()),
            .test = test_line(client)};
  info.statistics = client.statistics();
  info.open_s = std::chrono::duration<double>(Clock::now() - start).count();
  const msg::BoardInfo& board = info.board.info;
  add_flags(board.board_features, info.features);
  add_flags(board.board_features_ext, info.features);
  if (info.board.details) add_flags(info.board.details->board_features_ext2, info.features);
  add_flags(board.debug_mode, info.states);
  add_flags(board.connection_flags, info.states);
  info.unsupported = unsupported_commands(info.board.versions());
  return info;
}

std::string quality_text(const LineQuality& quality) {
  return fmt::format("{:.2g} % of frames damaged; about {:.2g} % are wrong without notice",
                     100 * quality.damaged, 100 * quality.undetected);
}

std::vector<std::string> names_of(const std::vector<Feature>& features, bool present) {
  std::vector<std::string> result;
  for (const Feature& feature : features) {
    if (feature.is_present == present) result.emplace_back(feature.info->name);
  }
  return result;
}

Json to_json(const Info& info) {
  const LineQuality quality = line_quality(info.statistics.session);
  Json line{{"description", info.line},
            {"framing", to_string(info.statistics.session.framing)},
            {"open_s", info.open_s},
            {"requests", info.test.sent},
            {"responses", info.test.times_ms.size()},
            {"skipped_bytes", info.statistics.session.parser.skipped_bytes},
            {"damaged_share", quality.damaged},
            {"undetected_share", quality.undetected}};
  if (!info.test.times_ms.empty()) {
    line["round_trip_ms"] = {{"min", info.test.times_ms.front()},
                             {"median", info.test.median()},
                             {"max", info.test.times_ms.back()}};
  }
  return {{"format", "sbgc-info"},
          {"version", 1},
          {"board", info.board.board_version()},
          {"firmware", info.board.firmware_version()},
          {"firmware_problem", info.board.firmware_problem()},
          {"serial_number", info.board.serial_number()},
          {"line", line},
          {"state", names_of(info.states, true)},
          {"features", names_of(info.features, true)},
          {"missing_features", names_of(info.features, false)},
          {"unsupported_commands", info.unsupported}};
}

std::string joined(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

/// Prints paragraphs with their names in the first column.
class Paragraphs {
 public:
  void print(const std::string& name, const std::string& text) const {
    const std::size_t padding = column - std::min(name.size(), column);
    fmt::print("{}{:{}}{}\n", bold_(Color::bold, name), "", padding,
               wrapped(printable(text), line_width(), column, column));
  }

  /// Prints as many names as fit into the line, and the number of the others.
  void print_some(const std::string& name, const std::vector<std::string>& words) const {
    const std::size_t width = line_width() - column;
    const auto cut_after = [&](std::size_t count) {
      const std::size_t more = words.size() - count;
      std::string text =
          joined({words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count)});
      if (count == 0) return std::to_string(more);
      return more == 0 ? text : fmt::format("{} and {} more", text, more);
    };
    std::size_t shown = words.size();
    while (shown != 0 && cut_after(shown).size() > width) --shown;
    print(name, words.empty() ? "none" : cut_after(shown));
  }

  static constexpr std::size_t column = 15;

 private:
  Colors bold_{stdout};
};

void print_text(const Info& info, bool all) {
  const Paragraphs out;
  const std::string serial = info.board.serial_number();
  out.print("board",
            info.board.board_version() + (serial.empty() ? "" : ", serial number " + serial));
  const std::string problem = info.board.firmware_problem();
  out.print("firmware", info.board.firmware_version() + (problem.empty() ? "" : ": " + problem));
  out.print("line", info.line);
  out.print("", fmt::format("framing {}, open for {:.1f} s, {} bytes skipped",
                            to_string(info.statistics.session.framing), info.open_s,
                            info.statistics.session.parser.skipped_bytes));
  const LineQuality quality = line_quality(info.statistics.session);
  if (quality.damaged > 0) out.print("", quality_text(quality));
  std::string test =
      fmt::format("{} of {} requests answered", info.test.times_ms.size(), info.test.sent);
  if (!info.test.times_ms.empty()) {
    test += fmt::format(" in {:.1f} ms ({:.1f} to {:.1f} ms)", info.test.median(),
                        info.test.times_ms.front(), info.test.times_ms.back());
  }
  out.print("", test);
  if (!all) {
    out.print_some("state", names_of(info.states, true));
    out.print_some("features", names_of(info.features, true));
    out.print_some("without", names_of(info.features, false));
    out.print_some("not supported", info.unsupported);
    return remark("(--all lists and explains everything)\n");
  }
  std::string name = "state";
  for (const Feature& state : info.states) {
    if (!state.is_present) continue;
    out.print(name, fmt::format("{}: {}", state.info->name, state.info->summary));
    name = "";
  }
  name = "features";
  for (const Feature& feature : info.features) {
    if (!feature.is_present) continue;
    out.print(name, fmt::format("{}: {}", feature.info->name, feature.info->summary));
    name = "";
  }
  out.print("without", joined(names_of(info.features, false)));
  out.print("not supported", joined(info.unsupported));
}

int print_info(const InfoOptions& options, const CommandContext& context) {
  const Info info = collect(context);
  if (options.format == "json") {
    fmt::print("{}\n", detail::json_text(to_json(info), 2));
  } else {
    print_text(info, options.all);
  }
  return success;
}

}  // namespace

void add_info(CLI::App& app, CommandContext& context) {
  const Subcommand<InfoOptions> command(app, context, "info",
                                        "Show the board, its line and its features");
  auto& options = command.options();
  command->add_flag("--all", options.all,
                    "List all features and commands, and explain those that the board has");
  add_format(*command, options.format);
  command->footer(
      "'without' lists the features that the board lacks, 'not supported' the commands that this "
      "board or its firmware does not have. It only reads. JSON has all details. The exit status "
      "is 0 if a board answered, 1 if none did, 2 for wrong usage.\n"
      "\n"
      "Examples:\n"
      "  sbgc info\n"
      "  sbgc info --all -p /dev/ttyUSB0\n"
      "  sbgc info --format json");
  command.runs(print_info);
}

}  // namespace sbgc::tools
