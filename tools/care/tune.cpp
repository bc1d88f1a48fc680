// sbgc tune: lets the board find the gains of its controllers.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include <sbgc/client/parameters.hpp>
#include <sbgc/client/tuning.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/messages/parameters.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/common_options.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "move/moving_gimbal.hpp"
#include "parameters/board_parameters.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

struct TuneOptions {
  std::vector<std::string> axes{};
  double gain = 50;  // percent
  bool from_current = false;
  bool filters = false;
  ProfileOption profile{};
  Arming arming{};
};

/// Returns the chosen axes, or all if none is named.
Axes<bool> chosen_axes(const TuneOptions& options) {
  Axes<bool> chosen{};
  for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
    chosen[axis] = options.axes.empty() ||
                   std::ranges::find(options.axes, axis_names[axis]) != options.axes.end();
  }
  return chosen;
}

msg::AutoPidRequest request_of(const TuneOptions& options, std::uint8_t profile) {
  return tuning_request({.axes = chosen_axes(options),
                         .gain = options.gain,
                         .from_current = options.from_current,
                         .filters = options.filters,
                         .profile = profile});
}

std::string report_text(const msg::AutoPid& report, const Axes<bool>& chosen) {
  std::string text = fmt::format("round {}", report.iter_num);
  for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
    if (!chosen[axis]) continue;
    text += fmt::format("; {} P {} I {:.2f} D {}, error {:.2f}", axis_names[axis], report.p[axis],
                        0.01 * report.i[axis], report.d[axis], report.axes[axis].tracking_error);
  }
  return text;
}

/// Prints the changes of the tuning, with the old and new values side by side.
void print_changes(const ParameterSet& before, const ParameterSet& after,
                   const Availability& versions) {
  const auto value = [](const std::string& raw, const std::string& meaning) {
    return meaning.empty() ? raw : meaning;
  };
  fmt::print("{:<34}{:>14}{:>14}\n", "parameter", "old", "new");
  bool has_changes = false;
  for (const ParametersChange& block : diff(before, after, versions, versions)) {
    for (const FieldChange& field : block.fields) {
      has_changes = true;
      fmt::print("{:<34}{:>14}{:>14}\n", field.path, value(field.before, field.before_meaning),
                 value(field.after, field.after_meaning));
    }
  }
  if (!has_changes) fmt::print("(nothing has changed)\n");
  std::fflush(stdout);
}

class TuningRun {
 public:
  TuningRun(MovingGimbal& gimbal, const TuneOptions& options)
      : gimbal_(gimbal),
        options_(options),
        profile_(choose_profile(gimbal.client(), options.profile)),
        request_(request_of(options, profile_.index)) {}

  /// Returns once the new values are kept.
  void run() {
    Client& client = gimbal_.client();
    require_known(client);
    require_possible(client, request_);
    before_ = read();
    arm(options_.arming, consequences());
    const MustFinish way_back(write_bound,
                              "the camera may still turn, and have new values; a guard process "
                              "stops it and writes the old ones if it can");
    gimbal_.begins_to_move(AfterStop::end_tuning, before_);
    const Result<void> tuned = shown_tuning();
    if (!tuned) give_up(tuned.error());
    gimbal_.has_stopped();
    try {
      print_changes(before_, read(), client.identity().versions());
    } catch (const std::exception&) {  // also if the terminal is gone
      remark("The new values could not be read or shown; the old ones return.\n");
      restore();
      throw;
    }
    const bool is_kept = options_.arming.yes || wants_to_keep();
    if (is_kept && !gimbal_.must_stop()) return;
    restore();
    if (gimbal_.must_stop())
      throw CommandError("interrupted; the old values are back", interrupted);
    throw CommandError("not kept; the old values are back");
  }

 private:
  static void require_known(const Client& client) {
    const Availability versions = client.identity().versions();
    if (is_supported<msg::AutoPidRequest>(versions) || !is_supported<msg::AutoPid2>(versions)) {
      return;
    }
    throw CommandError(
        "this firmware tunes with CMD_AUTO_PID2 instead of CMD_AUTO_PID: no document says what its "
        "gain means, nor how the board reports its progress and a failure, so this command does "
        "not "
        "send it; tune with the vendor's program, and keep the old values with `sbgc params "
        "backup`");
  }

  ParameterSet read() {
    return read_parameters(gimbal_.client(), [&](const ParametersId& id) {
      const bool has_gains = id.message == ParametersOf<msg::ReadParams3>::name ||
                             id.message == ParametersOf<msg::ReadParamsExt>::name;
      return has_gains && id.copy == profile_.index;
    });
  }

  std::string consequences() const {
    std::string names;
    const Axes<bool> chosen = chosen_axes(options_);
    for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
      if (chosen[axis]) names += (names.empty() ? "" : ", ") + std::string(axis_names[axis]);
    }
    return fmt::format(
        "The board shakes the camera about {} for some minutes and stores new gains in {}. Balance "
        "the camera, fasten the frame and keep your hands off. Ctrl-C ends it, and the old values "
        "return.",
        names, profile_.text());
  }

  /// Tunes until the board ends it, and shows the progress.
  Result<void> shown_tuning() {
    const ProgressBar bar;
    const auto show = [&](const std::optional<msg::AutoPid>& report) {
      if (gimbal_.must_stop()) return false;
      if (report) bar.show(report_text(*report, chosen_axes(options_)));
      return true;
    };
    return gimbal_.client().run(tasks::run_tuning(request_, {.progress = show}));
  }

  bool wants_to_keep() const {
    remark_as_is("Keep the new values? [y/N] ");
    while (!gimbal_.wait(std::chrono::seconds(1), STDIN_FILENO)) {
      if (gimbal_.must_stop()) return false;
    }
    std::string answer;
    std::getline(std::cin, answer);
    return detail::is_same_word(answer, "y") || detail::is_same_word(answer, "yes");
  }

  /// Writes the old values, if the board has different ones.
  void restore() { check_outcome(gimbal_.client().write_parameters(before_)); }

  /// Ends a failed tuning.
  [[noreturn]] void give_up(const ClientError& problem) {
    Client& client = gimbal_.client();
    const Result<void> ended = client.run(tasks::end_tuning());
    const Result<void> stopped = client.stop();
    if (stopped && ended) gimbal_.has_stopped();
    if (!ended) {
      remark("The board may go on tuning, and store new gains at its end: {}\n",
             ended.error().message);
    }
    const WriteReport restored = client.write_parameters(before_);
    remark("{}\n", restored ? "The old values are on the board."
                            : "The old values could not be written: " + to_text(restored));
    gimbal_.give_up(problem);
  }

  MovingGimbal& gimbal_;
  const TuneOptions& options_;
  ChosenProfile profile_;
  msg::AutoPidRequest request_;
  ParameterSet before_{};
};

int tune(const TuneOptions& options, const CommandContext& context) {
  {
    MovingGimbal gimbal(context.gimbal);
    TuningRun(gimbal, options).run();
  }  // from here on, no guard would restore the old values
  remark("The new values are kept.\n");
  return success;
}

}  // namespace

void add_tune(CLI::App& app, CommandContext& context) {
  const Subcommand<TuneOptions> command(app, context, "tune", "Tune the controllers automatically");
  auto& options = command.options();
  command->add_option("axes", options.axes, "The axes to tune; by default all")
      ->transform(one_of({"roll", "pitch", "yaw"}));
  command->add_option("--gain", options.gain, "From 0 (stability) to 100 (high gains)")
      ->type_name("PERCENT")
      ->check(number_range(0.0, 100.0))
      ->capture_default_str();
  command->add_flag("--from-current", options.from_current, "Begin with the present gains");
  command->add_flag("--filters", options.filters, "Tune the low-pass filters as well");
  add_profile_option(*command, options.profile);
  command->footer(
      "The motors must be on. It shows the progress, then the old and new values, and asks "
      "whether to keep the new ones; --yes keeps them. Otherwise, and after Ctrl-C, it writes "
      "the old ones back, which may take 60 s. If the command dies, or after a second Ctrl-C at "
      "least half a second later, a guard process ends the tuning and writes the old values "
      "back. Firmware from 2.73 on tunes with another request, which is hardly documented and "
      "which this command does not send.\n"
      "\n"
      "Examples:\n"
      "  sbgc tune\n"
      "  sbgc tune pitch --gain 30 --from-current\n"
      "\n"
      "The exit status is 0 if the new values are kept, 1 if not, 2 for wrong usage, 130 after "
      "Ctrl-C.");
  command.runs(tune);
}

}  // namespace sbgc::tools
