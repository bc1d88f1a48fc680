// sbgc bode: records the frequency response of an axis, and shows it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/client/bode.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/io/internal/atomic_file.hpp>
#include <sbgc/meta/calibration.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/validate.hpp>

#include "board/local_file.hpp"
#include "command/background_output.hpp"
#include "command/common_options.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "move/bode_recorder.hpp"
#include "move/move_way.hpp"
#include "move/response_output.hpp"

namespace sbgc::tools {

namespace {

// The limits of a recording. Assumption: a longer or stronger one is a mistake.
constexpr double least_seconds = 4;  // same as in the vendor's program
constexpr double most_gain = 10'000;
constexpr double most_frequency = 500;
constexpr std::size_t most_positions = 100;

struct BodeCommand {
  std::string axis{};
  unsigned gain = 0;
  unsigned from = 0, to = 0;
  double seconds = 4;
  std::string stimulus = "WHITE_NOISE";
  std::string system = "OPEN_LOOP_PLANT";
  std::vector<std::string> positions{};
  std::string output{};
  bool force = false;
  std::string on_cancel = "wait";
  std::vector<std::string> read{};
  bool table = false;
  std::string svg{};
  Arming arming{};
};

/// Returns the value with this name. Throws CommandError, which lists the names.
template <class E>
E bode_value(const std::string& word, const char* option) {
  std::string names;
  for (const ValueInfo& value : EnumMeta<E>::info.values) {
    if (detail::is_same_word(word, value.name)) return static_cast<E>(value.value);
    names += fmt::format("{}{}", names.empty() ? "" : ", ", value.name);
  }
  throw CommandError(fmt::format("{} '{}' is none of {}", option, clipped(word), names),
                     wrong_usage);
}

msg::BodeTestStartStopRequest bode_request(const BodeCommand& command) {
  if (command.axis.empty()) throw CommandError("say the axis: roll, pitch or yaw", wrong_usage);
  if (command.gain == 0 || command.from == 0 || command.to == 0) {
    throw CommandError(
        "say --gain, --from and --to: how strong the stimulus is, and its frequencies",
        wrong_usage);
  }
  if (command.from > command.to) {
    throw CommandError(fmt::format("--from {} is above --to {}", command.from, command.to),
                       wrong_usage);
  }
  msg::BodeTestStartStopRequest request;
  request.axis = bode_value<msg::BodeAxis>(command.axis, "the axis");
  request.stimulus_type = bode_value<msg::BodeStimulus>(command.stimulus, "--stimulus");
  request.stimulus_gain = static_cast<std::uint16_t>(command.gain);
  request.start_freq = msg::Frequency(static_cast<std::uint16_t>(command.from));
  request.end_freq = msg::Frequency(static_cast<std::uint16_t>(command.to));
  request.system = bode_value<msg::BodeSystem>(command.system, "--system");
  request.samples_num = bode_samples(command.seconds);
  if (!has_frequencies(request)) {
    throw CommandError(
        fmt::format("no frequency of the response, a multiple of {:.2f} Hz, is from --from {} to "
                    "--to {}",
                    resolution_of(request), command.from, command.to),
        wrong_usage);
  }
  return request;
}

/// A planned recording.
struct PlannedRecording {
  std::optional<RecordingPosition> position{};  ///< nothing: the present position
  std::string name{};
  std::string file{};  ///< empty if the samples are not saved
};

RecordingPosition position_of(const msg::GetAngles& state) {
  return {state.axes.roll.imu_angle.degrees(), state.axes.pitch.imu_angle.degrees()};
}

/// Returns a file name as in the vendor's example, such as ROLL_R0_P-30_Y12.csv. The pan axis stays
/// where it is.
std::string position_file(const BodeCommand& command, const RecordingPosition& position,
                          double yaw) {
  return fmt::format("{}_R{}_P{}_Y{}.csv", detail::upper_case(command.axis), position.roll,
                     position.pitch, std::lround(yaw));
}

std::vector<PlannedRecording> plan_recordings(const BodeCommand& command,
                                              const std::vector<RecordingPosition>& positions,
                                              const msg::GetAngles& now) {
  if (positions.empty()) return {{std::nullopt, command.axis, command.output}};
  std::vector<PlannedRecording> plan;
  for (const RecordingPosition& position : positions) {
    const std::string name = position_file(command, position, now.axes.yaw.imu_angle.degrees());
    plan.push_back({position, name, {}});
    if (command.output.empty()) continue;
    plan.back().file = (std::filesystem::path(command.output) / name).string();
  }
  return plan;
}

/// Throws CommandError if a file cannot be written, or two are equal: before the camera shakes.
void check_files(const BodeCommand& command, const std::vector<PlannedRecording>& plan) {
  std::vector<std::string> files;
  files.reserve(plan.size() + 1);
  for (const PlannedRecording& one : plan) files.push_back(one.file);
  files.push_back(command.svg);
  std::erase(files, "");
  const std::filesystem::path folder = command.positions.empty() ? "" : command.output;
  const bool is_new_folder = !folder.empty() && !std::filesystem::exists(folder);
  if (!folder.empty() && !is_new_folder && !std::filesystem::is_directory(folder)) {
    throw CommandError(fmt::format("{} is no folder; with --at, -o names one", folder.string()));
  }
  std::set<std::filesystem::path> seen;
  for (const std::string& file : files) {
    if (!seen.insert(std::filesystem::weakly_canonical(file)).second) {
      throw CommandError(fmt::format("{} would be written twice", file), wrong_usage);
    }
    if (!is_new_folder || file == command.svg) check_writable(file, command.force);
  }
}

/// After a signal, the command ends even if nobody reads.
void show_table(const std::string& text) {
  if (!was_interrupted()) return fmt::print("{}", text);
  background_stdout().write(text);
  background_stdout().finish();
}

void show_responses(const BodeCommand& command, const std::vector<NamedResponse>& responses) {
  for (const NamedResponse& one : responses) {
    if (one.response.segments == 0) {
      throw CommandError(one.name + ": too few samples without a gap for a frequency response");
    }
    if (one.response.points.empty()) {
      throw CommandError(one.name + ": no frequency of the response is in the range");
    }
    if (one.response.segments < analysis::least_segments) {
      remark("{}: too short for the coherence, which tells what can be trusted.\n", one.name);
    }
    if (!command.table) continue;
    const bool is_first = &one == &responses.front();
    const std::string title = responses.size() > 1 ? one.name + '\n' : "";
    show_table((is_first ? "" : "\n") + printable(title) + response_table(one.response));
  }
  if (command.svg.empty()) return;
  const std::string picture = response_svg(responses);
  write_local_file(command.svg, {picture.begin(), picture.end()}, command.force);
  remark("Drawn in {}.\n", command.svg);
}

int show_files(const BodeCommand& command) {
  if (!command.axis.empty() || !command.output.empty() || !command.positions.empty()) {
    throw CommandError("--read shows files: it takes no axis, -o or --at", wrong_usage);
  }
  std::vector<NamedResponse> responses;
  for (const std::string& file : command.read) {
    const std::vector<std::uint8_t> bytes = read_local_file(file, max_bode_csv);
    const auto recording =
        parse_bode_csv({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (!recording) throw CommandError(fmt::format("{}: {}", file, recording.error().message));
    responses.push_back({file, response_of(*recording)});
  }
  show_responses(command, responses);
  return success;
}

/// Describes the turns to the positions and back.
std::string turns_text(const std::vector<RecordingPosition>& positions,
                       const RecordingPosition& back, Axes<msg::Angle14> angles) {
  if (positions.empty()) return "";
  std::string turns, cables;
  const auto add = [&](const RecordingPosition& position, const char* before, const char* when) {
    const MoveTarget target = target_of(position);
    turns += before + target_text(target, angles, when);
    cables += cable_warning(target, angles);
    angles.roll = *target.roll;
    angles.pitch = *target.pitch;
  };
  for (const RecordingPosition& position : positions) {
    const bool is_first = &position == &positions.front();
    add(position, is_first ? "to " : "; then to ", is_first ? "now" : "from");
  }
  add(back, "; then back to ", "from");
  return fmt::format(" The camera turns {}, at up to {} deg/s.{}", turns, position_speed, cables);
}

std::string bode_warning(const BodeCommand& command, const msg::BodeTestStartStopRequest& request) {
  const bool off_at_once = command.on_cancel == "motors-off";
  return fmt::format(
      "The {} axis shakes for {} s, from {} to {} Hz with a gain of {}, and no command ends that. "
      "Ctrl-C {}.",
      command.axis, command.seconds, request.start_freq.raw(), request.end_freq.raw(),
      request.stimulus_gain,
      off_at_once
          ? "turns the motors off, and the camera drops to its heavy side"
          : "waits for the end; a second one turns the motors off, and the camera drops to its "
            "heavy side");
}

void report_lost_samples(const BodeRecording& recording) {
  if (recording.is_end_lost) {
    remark("The message of the end was lost on the line; the samples are kept.\n");
  }
  if (recording.lost == 0) return;
  remark("{} of {} were lost on the line; what contains a gap does not count.\n",
         counted(recording.lost, "sample"), recording.input.size());
}

void create_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw CommandError(fmt::format("cannot create {}: {}", folder, error.message()));
}

/// Returns false, with a message, if the file cannot be written but the recording is also shown.
bool save_recording(const BodeCommand& command, const std::string& file,
                    const BodeRecording& recording) {
  const std::string text = to_csv(recording);
  try {
    write_local_file(file, {text.begin(), text.end()}, command.force);
  } catch (const CommandError& error) {
    if (!command.table && command.svg.empty()) throw;
    remark_failure(as_message(error.what()));
    return false;
  }
  remark("Saved {} to {}.\n", counted(recording.input.size(), "sample"), file);
  return true;
}

struct MadeRecordings {
  std::vector<NamedResponse> responses{};
  bool are_saved = true;
};

/// Makes the recordings, unless a signal ends this early, and turns the camera back.
MadeRecordings make_recordings(const BodeCommand& command, MovingGimbal& gimbal,
                               const BodeRecorder& recorder,
                               const std::vector<PlannedRecording>& plan,
                               const msg::GetAngles& before) {
  MadeRecordings made;
  for (const PlannedRecording& one : plan) {
    if (one.position) recorder.go_to(*one.position);
    const BodeRecording recording = recorder.record();
    report_lost_samples(recording);
    if (!one.file.empty() && !save_recording(command, one.file, recording)) made.are_saved = false;
    made.responses.push_back({one.name, response_of(recording)});
    if (one.position && gimbal.must_stop()) gimbal.give_up({});
  }
  if (plan.front().position) {
    recorder.go_to(position_of(before));
  }
  return made;
}

/// Records with other streams paused. Errors after a signal end the command like the signal.
MadeRecordings record_undisturbed(const BodeCommand& command, MovingGimbal& gimbal,
                                  const msg::BodeTestStartStopRequest& request,
                                  const std::vector<PlannedRecording>& plan,
                                  const msg::GetAngles& before) {
  try {
    const MustFinish restart(stop_bound, "data streams of other hosts may stay paused");
    const PausedStreams streams(gimbal.client());
    if (was_interrupted()) throw CommandError("interrupted", interrupted);
    gimbal.begins_to_move(AfterStop::nothing);
    const BodeRecorder recorder(gimbal, request, command.on_cancel == "motors-off");
    MadeRecordings made = make_recordings(command, gimbal, recorder, plan, before);
    gimbal.has_stopped();
    return made;
  } catch (const CommandError& error) {
    if (!was_interrupted() || error.status() == interrupted) throw;
    throw CommandError(fmt::format("interrupted; {}", error.what()), interrupted);
  }
}

int record_responses(const BodeCommand& command, const CommandContext& context) {
  const msg::BodeTestStartStopRequest request = bode_request(command);
  if (command.positions.size() > most_positions) {
    throw CommandError(fmt::format("at most {} positions are possible", most_positions),
                       wrong_usage);
  }
  std::vector<RecordingPosition> positions;
  positions.reserve(command.positions.size());
  for (const std::string& text : command.positions) positions.push_back(parse_position(text));
  // Errors are found before the camera shakes; file names need a gimbal only for yaw.
  check_files(command, plan_recordings(command, positions, {}));

  MovingGimbal gimbal(context.gimbal);
  require_possible(gimbal.client(), request);
  const auto before = value_of(Result<msg::GetAngles>(gimbal.client().get_angles()));
  const std::vector<PlannedRecording> plan = plan_recordings(command, positions, before);
  check_files(command, plan);
  arm(command.arming, bode_warning(command, request) +
                          turns_text(positions, position_of(before), angles_of(before)));
  if (!positions.empty() && !command.output.empty()) create_folder(command.output);
  const Interruption interruption;
  const MadeRecordings made = record_undisturbed(command, gimbal, request, plan, before);
  show_responses(command, made.responses);
  if (was_interrupted()) throw CommandError("interrupted; the recording is complete", interrupted);
  return made.are_saved ? success : failure;
}

int run_bode(const BodeCommand& command, const CommandContext& context) {
  if (command.output.empty() && !command.table && command.svg.empty()) {
    throw CommandError("say what to do with the response: -o, --table or --svg", wrong_usage);
  }
  return command.read.empty() ? record_responses(command, context) : show_files(command);
}

}  // namespace

void add_bode(CLI::App& app, CommandContext& context) {
  const Subcommand<BodeCommand> command(app, context, "bode",
                                        "Record the frequency response of an axis");
  auto& options = command.options();
  command->add_option("axis", options.axis, "roll, pitch or yaw")
      ->transform(one_of({"roll", "pitch", "yaw"}));
  command->add_option("--gain", options.gain, "How strong the stimulus is; begin with 1000")
      ->check(number_range(1, most_gain))
      ->type_name("NUMBER");
  command->add_option("--from", options.from, "The lowest frequency, in Hz")
      ->check(number_range(1, most_frequency))
      ->type_name("HZ");
  command->add_option("--to", options.to, "The highest frequency, in Hz")
      ->check(number_range(1, most_frequency))
      ->type_name("HZ");
  command->add_option("--seconds", options.seconds, "How long to record")
      ->check(number_range(least_seconds, longest_recording))
      ->type_name("NUMBER")
      ->capture_default_str();
  command->add_option("--stimulus", options.stimulus, "What shakes the axis")
      ->type_name("STIMULUS")
      ->capture_default_str();
  command->add_option("--system", options.system, "What to measure")
      ->type_name("SYSTEM")
      ->capture_default_str();
  command
      ->add_option("--at", options.positions,
                   "Turn the camera here first, in degrees; repeat it to record at several "
                   "positions")
      ->type_name("ROLL,PITCH")
      ->allow_extra_args(false);
  command
      ->add_option(
          "-o,--output", options.output,
          "Save the samples to this file (CSV of the vendor's program); with --at, to this folder")
      ->type_name("FILE");
  command->add_flag("--force", options.force, "Replace files");
  command->add_option("--on-cancel", options.on_cancel, "What Ctrl-C does during a recording")
      ->transform(one_of({"wait", "motors-off"}))
      ->capture_default_str();
  command->add_option("--read", options.read, "Show these files instead of recording")
      ->type_name("FILE");
  command->add_flag("--table", options.table, "Print frequency, gain, phase and coherence");
  command->add_option("--svg", options.svg, "Draw gain, phase and coherence")->type_name("FILE");
  command->footer(
      "`sbgc describe BodeStimulus` and `sbgc describe BodeSystem` list what --stimulus and "
      "--system take.\n"
      "\n"
      "The board shakes the axis and sends input and output, 1250 samples a second. No command "
      "ends a recording early: Ctrl-C waits, and a second one, at least half a second later, "
      "turns the motors off.\n"
      "\n"
      "The coherence is the share of the output that follows the stimulus: trust results where "
      "it is near 1. It needs at least 2.1 s without a gap.\n"
      "\n"
      "Examples:\n"
      "  sbgc bode roll --gain 1000 --from 6 --to 200 --table\n"
      "  sbgc bode pitch --gain 3000 --from 3 --to 200 --seconds 8 -o pitch.csv --svg pitch.svg\n"
      "  sbgc bode --read pitch.csv --table\n"
      "\n"
      "The exit status is 0 if the response was recorded; 1 if not; 2 for wrong usage; 130 after "
      "Ctrl-C.");
  command.runs(run_bode);
}

}  // namespace sbgc::tools
