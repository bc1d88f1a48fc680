// sbgc jog: turns the camera with the keys of the terminal.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

#include <sbgc/axis_directions.hpp>
#include <sbgc/client/speed_control.hpp>
#include <sbgc/messages/realtime.hpp>

#include "board/progress_bar.hpp"
#include "command/common_options.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/system.hpp"
#include "command/terminal_restorer.hpp"
#include "command/terminal_text.hpp"
#include "move/moving_gimbal.hpp"
#include "move/raw_terminal.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

struct JogOptions {
  Arming arming{};
};

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::array speeds{0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0};  // deg/s
constexpr std::size_t usual_speed = 4;

/// The direction of a key.
struct KeyTurn {
  std::size_t axis{};
  int sign{};
};

/// Returns the turn for, e.g., "up"; the sign is 0 if nothing turns the camera there.
consteval KeyTurn turn_to(std::string_view direction) {
  for (std::size_t axis = 0; axis < axis_directions.size(); ++axis) {
    if (axis_directions[axis].positive == direction) return {axis, 1};
    if (axis_directions[axis].negative == direction) return {axis, -1};
  }
  return {};
}

std::optional<KeyTurn> direction_of(const KeyPress& press) {
  constexpr std::size_t roll = 0;
  constexpr KeyTurn up = turn_to("up");
  constexpr KeyTurn down = turn_to("down");
  constexpr KeyTurn left = turn_to("left");
  constexpr KeyTurn right = turn_to("right");
  switch (press.key) {
    case Key::up: return up;
    case Key::down: return down;
    case Key::left: return left;
    case Key::right: return right;
    case Key::end: return std::nullopt;
    case Key::character: break;
  }
  switch (press.character) {
    case 'w': return up;
    case 's': return down;
    case 'a': return left;
    case 'd': return right;
    case 'z': return KeyTurn{roll, -1};
    case 'c': return KeyTurn{roll, 1};
    default: return std::nullopt;
  }
}

/// The turning axes: those whose key is held, according to its repetitions.
class HeldKeys {
 public:
  void press(const KeyTurn& direction, Clock::time_point now) {
    Held& held = held_[direction.axis];
    const bool repeats = now < held.until && held.sign == direction.sign;
    // The first repetition of a held key comes after a longer pause.
    constexpr milliseconds first{550};
    constexpr milliseconds next{200};
    held = {direction.sign, std::max(held.until, now + (repeats ? next : first))};
    if (repeats) held.until = now + next;
  }
  void release() { held_ = {}; }
  /// Returns -1, 0 or 1 for each axis.
  std::array<int, 3> signs(Clock::time_point now) const {
    std::array<int, 3> result{};
    for (std::size_t i = 0; i < held_.size(); ++i) {
      result[i] = now < held_[i].until ? held_[i].sign : 0;
    }
    return result;
  }

 private:
  struct Held {
    int sign{};
    Clock::time_point until{};
  };
  std::array<Held, 3> held_{};
};

/// The state of the keyboard control.
class Jog {
 public:
  Jog(MovingGimbal& gimbal, SpeedControl& control) : gimbal_(gimbal), control_(control) {}

  /// True if Ctrl-C, which is a key in this terminal, ended it.
  bool is_interrupted() const noexcept { return is_interrupted_; }

  /// Runs until a key ends it or the motion must stop.
  Result<void> run() {
    RawTerminal terminal;
    while (!gimbal_.must_stop()) {
      if (!take_keys(terminal)) return {};
      if (Result<void> turned = turn(); !turned) return turned;
      show();
      constexpr milliseconds interval{50};
      static_cast<void>(gimbal_.wait(interval, STDIN_FILENO));
    }
    return {};
  }

 private:
  /// Returns false if a key or the end of the terminal ends the control.
  bool take_keys(RawTerminal& terminal) {
    constexpr char ctrl_c = 3;
    constexpr char ctrl_d = 4;
    while (const auto press = terminal.next()) {
      if (press->key == Key::end) return false;
      if (const auto direction = direction_of(*press)) {
        keys_.press(*direction, Clock::now());
        continue;
      }
      switch (press->character) {
        case ctrl_c: is_interrupted_ = true; return false;
        case 'q':
        case ctrl_d: return false;
        case ' ': keys_.release(); break;
        case '+':
        case '=': speed_ = std::min(speed_ + 1, speeds.size() - 1); break;
        case '-': speed_ -= speed_ == 0 ? 0 : 1; break;
        default: break;
      }
    }
    return true;
  }

  Result<void> turn() {
    const std::array<int, 3> signs = keys_.signs(Clock::now());
    Axes<msg::ControlSpeed> speed;
    const bool turns = std::ranges::any_of(signs, [](int sign) { return sign != 0; });
    for (std::size_t i = 0; i < signs.size(); ++i) {
      speed[i] = to_speed(signs[i] * speeds[speed_], axis_names[i]);
    }
    if (turns) return control_.set(speed);
    return control_.state() == SpeedControl::State::turning ? control_.stop() : Result<void>();
  }

  void show() {
    const auto now = Clock::now();
    constexpr milliseconds interval{250};
    if (now < shown_ + interval) return;
    shown_ = now;
    constexpr std::size_t least = 60;  // enough for everything it shows
    const bool is_narrow = line_width(stderr) < least;
    // A lost response only delays the display.
    CallOptions options;
    options.timeout = milliseconds(100);
    const Result<msg::GetAngles> state = gimbal_.client().call(msg::GetAnglesRequest{}, options);
    if (state) {
      angles_.clear();
      for (std::size_t i = 0; i < axis_names.size(); ++i) {
        const double angle = state->axes[i].imu_angle.degrees();
        angles_ += is_narrow ? fmt::format("{} {:.0f} ", axis_names[i], angle)
                             : fmt::format("{} {:7.1f}  ", axis_names[i], angle);
      }
    }
    bar_.show(fmt::format("{}{}{:g} deg/s", angles_, is_narrow ? "" : "speed ", speeds[speed_]));
  }

  MovingGimbal& gimbal_;
  SpeedControl& control_;
  HeldKeys keys_{};
  std::size_t speed_ = usual_speed;
  std::string angles_{};
  Clock::time_point shown_{};
  ProgressBar bar_{};
  bool is_interrupted_ = false;
};

int jog(const JogOptions& options, const CommandContext& context) {
  if (!is_terminal(stdin) || !is_terminal(stderr)) {
    throw CommandError("jog needs a terminal with a keyboard");
  }
  const TerminalRestorer restorer(TerminalRestorer::Screen::normal);
  MovingGimbal gimbal(context.gimbal);
  arm(options.arming,
      fmt::format("Up looks up, and down looks down: the reverse of sbgc 0.1.0. The camera turns "
                  "while a key is held, at up to {:g} deg/s.",
                  speeds.back()));
  gimbal.begins_to_move(AfterStop::remove_timeout);
  remark("{}\n", wrapped("arrows or w, a, s, d: up, left, down, right; z, c: roll; space: stop; "
                         "+, -: speed; q: quit",
                         line_width(stderr)));
  Result<void> ended;
  bool is_interrupted = false;
  {
    SpeedControl control(gimbal.client(), {.ends_when_stopped = true});
    Jog keyboard(gimbal, control);
    ended = keyboard.run();
    is_interrupted = keyboard.is_interrupted();
    const Result<void> stopping = control.stop();
    const Result<void> stopped = stopping ? control.wait() : stopping;
    if (ended) ended = stopped;
  }
  if (!ended) gimbal.give_up(ended.error());
  gimbal.has_stopped();
  if (gimbal.must_stop()) gimbal.give_up({});
  remark("The camera has stopped.\n");
  return is_interrupted ? interrupted : success;
}

}  // namespace

void add_jog(CLI::App& app, CommandContext& context) {
  const Subcommand<JogOptions> command(app, context, "jog", "Turn the camera with the keyboard");
  command->footer(
      "Keys, in a terminal that repeats a held key:\n"
      "  up, down or w, s       look up, down\n"
      "  left, right or a, d    look left, right\n"
      "  z, c                   turn roll, negative and positive\n"
      "  space                  stop\n"
      "  +, -                   change the speed\n"
      "  q                      quit\n"
      "\n"
      "The camera stops when you release the key, and as described for `sbgc speed`.\n"
      "\n"
      "The exit status is 0 after q, 1 if something failed, 2 for wrong usage, 130 after Ctrl-C "
      "or another signal.");
  command.examples({"sbgc jog"});
  command.runs(jog);
}

}  // namespace sbgc::tools
