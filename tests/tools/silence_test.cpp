// Silence is no success: what commands do on a board, with each of their requests lost in turn, in
// virtual time.

#include <algorithm>
#include <chrono>
#include <functional>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/any.hpp>
#include <sbgc/client/calibrations.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/client/tasks.hpp>
#include <sbgc/roles.hpp>

#include "../client/virtual_client.hpp"
#include "move/menu_action.hpp"
#include "parameters/defaults.hpp"

namespace sbgc::tools {
namespace {

using test::VirtualClient;

/// Loses a request: once, or each time it is sent. Or the confirmations that a board may leave out.
class LosingLine : public test::VirtualLine {
 public:
  enum class Loss : std::uint8_t { none, once, always, confirmations };

  void lose(Loss loss, std::size_t number = 0) {
    loss_ = loss;
    number_ = number;
    sent_ = 0;
    lost_.reset();
  }
  std::size_t sent() const { return sent_; }

  void send(Way way, std::span<const std::uint8_t> bytes, Instant now) override {
    const std::uint8_t command = bytes.size() > 1 ? bytes[1] : 0;
    bool is_lost = loss_ == Loss::confirmations && way == Way::to_host &&
                   command == static_cast<std::uint8_t>(roles::Confirmation::command) &&
                   may_leave_out(bytes[4]);
    if (way == Way::to_board) {
      const bool is_it = sent_++ == number_;
      if (is_it && loss_ == Loss::always) lost_ = command;
      is_lost = (is_it && loss_ == Loss::once) || lost_ == command;
    }
    if (!is_lost) VirtualLine::send(way, bytes, now);
  }

 private:
  static bool may_leave_out(std::uint8_t command) {
    const auto types = message_types();
    return std::any_of(types.begin(), types.end(), [&](const MessageType* type) {
      return type->is_sent_to_board() && type->info->id == command &&
             detail::policy_of(type->make()).responses.confirmed != Confirmed::always;
    });
  }

  Loss loss_ = Loss::none;
  std::size_t number_ = 0;
  std::size_t sent_ = 0;
  std::optional<std::uint8_t> lost_{};
};

using Loss = LosingLine::Loss;

/// The effects of a command.
struct Done {
  std::set<unsigned> executed{};  ///< ids of requests that do something
  emulator::Memory memory{};
  bool motors_on = false;
};

struct Command {
  std::string name{};
  std::function<Result<void>(VirtualClient&)> run{};
  std::function<void(VirtualClient&)> before{};
};

template <class T>
Result<void> without_value(const Result<T>& result) {
  return result ? Result<void>() : Result<void>(result.error());
}

/// A command that is a task.
template <class Make>
Command task(std::string name, Make make, std::function<void(VirtualClient&)> before = {}) {
  return {std::move(name),
          [make](VirtualClient& client) { return without_value(client.run(make())); },
          std::move(before)};
}

emulator::EmulatorOptions board_with(int firmware) {
  emulator::EmulatorOptions options;
  options.board.firmware = msg::FirmwareVersion(static_cast<std::uint16_t>(firmware));
  options.board.gimbal.noise = 0;
  options.board.calibration_time = 5;
  return options;
}

Task<Result<void>> set_parameter(std::uint8_t profile) {
  ReadOptions reading;
  reading.wanted = [profile](const ParametersId& id) {
    return id == ParametersId{ParametersOf<msg::ReadParams3>::name, profile};
  };
  const Result<ParameterSet> present = co_await tasks::read_parameters(reading);
  if (!present) co_return present.error();
  auto parameters = present->get<msg::ReadParams3>(profile);
  parameters->gyro_trust ^= 1U;
  ParameterSet wanted;
  static_cast<void>(wanted.set(*parameters));
  const WriteReport report = co_await tasks::write_parameters(wanted);
  co_return report.outcome;
}

Task<Result<void>> read_defaults() {
  ReadOptions reading;
  reading.wanted = [](const ParametersId& id) { return id.copy == 4; };
  const Result<ParameterSet> before = co_await tasks::read_parameters(reading);
  if (!before) co_return before.error();
  const CallOptions usual;
  const Result<ParameterSet> found = co_await find_defaults(4, *before, usual);
  co_return found ? Result<void>() : Result<void>(found.error());
}

template <Message M>
Task<CallResult<M>> confirmed(M request) {
  co_return co_await tasks::call(request, confirming());
}

/// As `sbgc speed` does.
Result<void> turn(VirtualClient& client) {
  const auto speed = client.held_speed();
  bool has_ended = false;
  TaskMachine& machine = client.start(
      detail::hold_speed(
          speed, detail::BoundedTurn(MotionBound::automatic, std::chrono::milliseconds(500)), true),
      [&](const Result<void>&) { has_ended = true; });
  Result<void> set;
  for (const Instant end = client.now() + sbgc::milliseconds(600); set && client.now() < end;) {
    set = speed->set({{}, {}, msg::ControlSpeed(100)}, client.now());
    machine.wake();
    client.pass(sbgc::milliseconds(100));
  }
  const Result<void> stopping = speed->stop();
  speed->close();
  machine.wake();
  while (!has_ended) client.pass(sbgc::milliseconds(10));
  if (!set) return set;
  return stopping ? speed->outcome() : stopping;
}

const std::vector<std::uint8_t> content(300, 'x');

void start_script(VirtualClient& client) {
  ASSERT_TRUE(client.run(tasks::upload_file(0, content)));
  ASSERT_TRUE(client.run(confirmed(msg::RunScript{.mode = msg::ScriptMode::start})));
}

std::vector<Command> commands() {
  using Menu = msg::MenuCommand;
  const auto put_file = [](VirtualClient& client) {
    ASSERT_TRUE(client.run(tasks::upload_file(0, content)));
  };
  const auto change_profile = [](VirtualClient& client) {
    ASSERT_TRUE(client.run(set_parameter(4)));
  };
  msg::Control control;
  control.control_mode.set_mode(msg::ControlModeKind::speed);
  control.axes.yaw.speed = msg::ControlSpeed(100);
  const auto is_turning = [control](VirtualClient& client) {
    ASSERT_TRUE(client.run(confirmed(control)));
    client.pass(sbgc::milliseconds(200));
  };
  std::vector<Command> all{
      task("menu home_position", [] { return perform(Menu::home_position, {}); }),
      task("menu profile2", [] { return perform(Menu::profile2, {}); }),
      task("menu frame_upside_down", [] { return perform(Menu::frame_upside_down, {}); }),
      task(
          "script start", [] { return confirmed(msg::RunScript{.mode = msg::ScriptMode::start}); },
          put_file),
      task(
          "script stop", [] { return confirmed(msg::RunScript{}); }, start_script),
      task("motors on", [] { return confirmed(msg::MotorsOn{}); }),
      task(
          "motors off", [] { return confirmed(msg::MotorsOff{}); },
          [](VirtualClient& client) { ASSERT_TRUE(client.run(confirmed(msg::MotorsOn{}))); }),
      task("move", [] { return tasks::begin_move({.yaw = msg::Angle14(500)}); }),
      task("move --wait", [] { return tasks::move_to({.yaw = msg::Angle14(500)}); }),
      task(
          "stop", [] { return tasks::stop(); }, is_turning),
      {"speed", turn},
      task("params set", [] { return set_parameter(1); }),
      task("params rename", [] { return tasks::rename_profile(1, "Studio"); }),
      task("params diff --defaults", read_defaults, change_profile),
      task("params diff --defaults of a new board", read_defaults),
      task("vars set", [] { return tasks::set_variable("P_ROLL", 33); }),
      task(
          "vars save", [] { return tasks::save_variables(); },
          [](VirtualClient& client) {
            ASSERT_TRUE(client.run(tasks::set_variable("P_ROLL", 33)));
          }),
      task("eeprom write", [] { return tasks::upload_eeprom(1024, content); }),
      task("files put", [] { return tasks::upload_file(3, content); }),
      task(
          "files remove", [] { return tasks::delete_file(0); }, put_file),
      task(
          "files clear", [] { return tasks::delete_all_files(); }, put_file),
  };
  msg::CalibBat battery;
  battery.actual_voltage = msg::Voltage(1200);
  all.push_back(task("calibrate battery", [battery] { return tasks::run_calibration(battery); }));
  for (const Calibration& one : calibrations()) {
    if (one.needs_values) continue;
    const AnyMessage request = find_message(one.info().name)->make();
    all.push_back(task(std::string("calibrate ") + one.name,
                       [request] { return tasks::run_calibration(request, {}); }));
  }
  return all;
}

/// Runs a command on a new board; returns what it did if it says that it has succeeded.
std::optional<Done> effect_of(const Command& command, int firmware, Loss loss, std::size_t number,
                              std::size_t* sent = nullptr) {
  LosingLine line;
  VirtualClient client(board_with(firmware), {}, &line);
  if (command.before) command.before(client);
  Done effect;
  client.emulator().board().on_traffic = [&](const emulator::Board::Traffic& one) {
    if (one.reaction != emulator::Reaction::executed) return;
    const MessageType* const type =
        find_message(Direction::to_board, one.frame.id, one.frame.body.size());
    if (type == nullptr || type->info->effects.has(Effect::reads)) return;
    effect.executed.insert(one.frame.id);
  };
  line.lose(loss, number);
  const Result<void> done = command.run(client);
  if (sent != nullptr) *sent = line.sent();
  if (!done) return std::nullopt;
  client.pass(sbgc::milliseconds(100));
  effect.memory = client.emulator().board().memory();
  effect.memory.revision = 0;
  effect.motors_on = client.gimbal().motors_on();
  client.emulator().board().on_traffic = {};
  return effect;
}

TEST(Silence, IsNoSuccess) {
  std::set<std::string> possible;
  for (const int firmware : {2439, 2590, 2740}) {
    for (const Command& command : commands()) {
      std::size_t requests = 0;
      const auto wanted = effect_of(command, firmware, Loss::none, 0, &requests);
      if (!wanted) continue;  // this board cannot do it
      possible.insert(command.name);
      for (const Loss loss : {Loss::once, Loss::always}) {
        for (std::size_t number = 0; number < requests; ++number) {
          const auto effect = effect_of(command, firmware, loss, number);
          if (!effect) continue;
          const std::string what =
              fmt::format("{} on {}, request {} lost {}", command.name, firmware, number,
                          loss == Loss::once ? "once" : "always");
          EXPECT_TRUE(std::ranges::includes(effect->executed, wanted->executed)) << what;
          EXPECT_EQ(effect->memory, wanted->memory) << what;
          EXPECT_EQ(effect->motors_on, wanted->motors_on) << what;
        }
      }
    }
  }
  for (const Command& command : commands())
    EXPECT_TRUE(possible.contains(command.name)) << command.name;
}

TEST(Silence, WhatDoesNoHarmTwiceIsRepeated) {
  const std::set<std::string> repeated{"menu home_position", "menu profile2", "script stop",
                                       "vars save", "params rename"};
  const std::set<std::string> sent_once{"menu frame_upside_down", "script start"};
  for (const Command& command : commands()) {
    const bool is_repeated = repeated.contains(command.name);
    if (!is_repeated && !sent_once.contains(command.name)) continue;
    EXPECT_EQ(effect_of(command, 2590, Loss::once, 0).has_value(), is_repeated) << command.name;
  }
}

// A board that confirms nothing.
TEST(Silence, WhatCanBeReadBackIsReadBack) {
  for (const Command& command : commands()) {
    const bool is_readable = command.name == "menu profile2" || command.name.starts_with("params ");
    const bool is_told_only_so = command.name == "menu home_position" ||
                                 command.name.starts_with("script ") || command.name == "vars save";
    if (!is_readable && !is_told_only_so) continue;
    EXPECT_EQ(effect_of(command, 2590, Loss::confirmations, 0).has_value(), is_readable)
        << command.name;
  }
}

}  // namespace
}  // namespace sbgc::tools
