// Tests the examples as a user runs them: over a serial port, here a pseudo-terminal.

#include <cstdio>

#include <sys/wait.h>

#include "task_test.hpp"

namespace sbgc::test {
namespace {

struct ProgramResult {
  int status{};
  std::string output{};  ///< of both streams
};

/// Runs a shell command to its end.
ProgramResult run_program(const std::string& command) {
  ProgramResult result;
  std::FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> block{};
  for (std::size_t size = 1; size > 0;) {
    size = std::fread(block.data(), 1, block.size(), pipe);
    result.output.append(block.data(), size);
  }
  result.status = WEXITSTATUS(::pclose(pipe));
  return result;
}

/// A gimbal that moves to its target immediately.
class Examples : public ::testing::Test {
 protected:
  void SetUp() override {
    introduce(board);
    board.on<msg::MotorsOn>([this](const msg::MotorsOn& request) {
      motors.add("on");
      board.confirm(request);
    });
    board.on<msg::MotorsOff>([this](const msg::MotorsOff& request) {
      motors.add("off");
      board.confirm(request);
    });
    board.answer<msg::RealtimeData4Request>(msg::RealtimeData4{});
    board.on<msg::Control>([this](const msg::Control& request) { turn(request.axes.pitch.angle); });
    board.on<msg::ControlExt>(
        [this](const msg::ControlExt& request) { turn(request.axes.pitch.angle); });
    board.answer<msg::GetAnglesRequest>(angles_);
    board.on<msg::DataStreamInterval>([this](const msg::DataStreamInterval& request) {
      registrations.add(request);
      board.confirm(request);
      if (request.interval_ms.raw() == 0) return;
      for (int i = 0; i < 60; ++i) board.send(sample_);
    });
    auto opened = io::open_pseudo_terminal(board.executor(), {.stays_open = true});
    ASSERT_TRUE(opened) << opened.error.message;
    port = opened.transport->path();
    board.serve(std::move(opened.transport));
  }

 private:
  void turn(msg::Angle14 pitch) {
    moves.add(pitch);
    angles_.axes.pitch.imu_angle = angles_.axes.pitch.rc_target_angle = pitch;
    sample_.angle.pitch = pitch;
    sample_.angle.yaw = 12.5_deg;
    board.answer<msg::GetAnglesRequest>(angles_);
  }

  msg::GetAngles angles_;
  msg::RealtimeData4 sample_;

 protected:
  Collector<msg::DataStreamInterval> registrations;
  Collector<std::string> motors;
  Collector<msg::Angle14> moves;
  ScriptedBoard board;  // declared after the objects that its hooks use
  std::string port;
};

TEST_F(Examples, Quickstart) {
  const ProgramResult result = run_program(SBGC_EXAMPLE_QUICKSTART " " + port + " --yes");
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_THAT(result.output, AllOf(HasSubstr("board 3.0, firmware 2.59, on serial port " + port),
                                   HasSubstr("roll    0.0  pitch   30.0  yaw   12.5 degrees\n")));
  EXPECT_TRUE(registrations.wait_until([](const auto& requests) {
    return !requests.empty() && requests.back().interval_ms == msg::Milliseconds{};
  })) << "it does not end its stream";
}

TEST_F(Examples, QuickstartLeavesTheMotorsAsTheyWere) {
  EXPECT_EQ(run_program(SBGC_EXAMPLE_QUICKSTART " " + port + " --yes").status, 0);
  EXPECT_THAT(motors.wait_for(2), ElementsAre("on", "off"));
}

TEST_F(Examples, QuickstartLeavesMotorsOnThatWereOn) {
  msg::RealtimeData4 state{.other_flags = msg::OtherFlag::motors_on};
  board.answer<msg::RealtimeData4Request>(state);
  EXPECT_EQ(run_program(SBGC_EXAMPLE_QUICKSTART " " + port + " --yes").status, 0);
  EXPECT_THAT(motors.wait_for(0), IsEmpty());
}

TEST_F(Examples, QuickstartMovesNothingUnlessSomebodyAgrees) {
  for (const char* answer : {"echo no", "echo", "true"}) {
    const ProgramResult result =
        run_program(answer + std::string(" | " SBGC_EXAMPLE_QUICKSTART " ") + port);
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.output, HasSubstr("nothing has been moved"));
  }
  EXPECT_THAT(motors.wait_for(0), IsEmpty());
  EXPECT_EQ(run_program("echo yes | " SBGC_EXAMPLE_QUICKSTART " " + port).status, 0);
  EXPECT_FALSE(motors.wait_for(0).empty());
}

TEST_F(Examples, TiltMovesOnlyIfSomebodyAgrees) {
  const std::string tilt = std::string(SBGC_EXAMPLE_TILT) + " " + port;
  EXPECT_EQ(run_program("echo no | " + tilt).status, 1);
  EXPECT_EQ(moves.wait_for(0).size(), 0U);
  const ProgramResult result = run_program("echo yes | " + tilt);
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_EQ(moves.wait_for(1).back(), msg::Angle14(30_deg));
}

TEST_F(Examples, CoroutineMovesOnlyIfSomebodyAgrees) {
  const std::string coroutine = std::string(SBGC_EXAMPLE_COROUTINE) + " " + port;
  EXPECT_EQ(run_program("echo no | " + coroutine).status, 1);
  EXPECT_THAT(moves.wait_for(0), IsEmpty());
  const ProgramResult result = run_program("echo yes | " + coroutine);
  EXPECT_EQ(result.status, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("pitch 30.0 degrees\npitch 0.0 degrees\n"));
  EXPECT_THAT(moves.wait_for(2), AllOf(Contains(msg::Angle14(30_deg)), Contains(msg::Angle14{})));
}

TEST_F(Examples, AsyncStream) {
  const ProgramResult result = run_program(SBGC_EXAMPLE_ASYNC_STREAM " " + port);
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.output, AllOf(HasSubstr("firmware 2.59\n"), HasSubstr("50: yaw    0.0 deg")));
}

TEST_F(Examples, TellWhatIsWrong) {
  for (const char* program :
       {SBGC_EXAMPLE_QUICKSTART, SBGC_EXAMPLE_ASYNC_STREAM, SBGC_EXAMPLE_COROUTINE}) {
    EXPECT_EQ(run_program(program).status, 2);
    const ProgramResult result =
        run_program("echo yes | " + std::string(program) + " /dev/no-such-port");
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.output, HasSubstr("/dev/no-such-port"));
  }
}

class BackupExample : public TaskTest {
 protected:
  std::string file(const char* name) const { return (folder_.path() / name).string(); }

  ProgramResult backup(const std::string& arguments) const {
    return run_program(std::string(SBGC_EXAMPLE_BACKUP) + " " + port_ + " " + arguments);
  }

 private:
  std::string port_ = board.serve_terminal();
  TemporaryFolder folder_;
};

TEST_F(BackupExample, SavesComparesAndRestores) {
  const auto original = board.all_settings<msg::ReadParams3>();
  ProgramResult run = backup("save " + file("a.json"));
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_THAT(run.output,
              HasSubstr("saved the parameters of 18 messages of a board 3.0 with firmware 2.59"));
  EXPECT_NE(backup("save " + file("a.json")).status, 0) << "it would overwrite the first one";

  board.edit<msg::ReadParams3>(2, [](msg::ReadParams3& params) { params.gyro_trust = 1; });
  run = backup("diff " + file("a.json"));
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("ReadParams3 of profile 3:\n  gyro_trust: "));

  run = backup("restore " + file("a.json") + " " + file("before.json") + " --yes");
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("ReadParams3 of profile 3: written"));
  EXPECT_TRUE(std::filesystem::exists(file("before.json")));
  EXPECT_EQ(board.all_settings<msg::ReadParams3>(), original);

  run = backup("diff " + file("a.json"));
  EXPECT_THAT(run.output, HasSubstr("no differences"));
}

TEST_F(BackupExample, RestoresNothingUnlessThatIsAgreed) {
  ASSERT_EQ(backup("save " + file("a.json")).status, 0);
  board.edit<msg::ReadParams3>(2, [](msg::ReadParams3& params) { params.gyro_trust = 1; });
  const auto edited = board.all_settings<msg::ReadParams3>();
  std::ofstream(file("no")) << "no\n";
  for (const std::string& input : {file("no"), std::string("/dev/null")}) {
    const ProgramResult run =
        backup("restore " + file("a.json") + " " + file("before.json") + " <" + input);
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("Type yes"));
    EXPECT_FALSE(std::filesystem::exists(file("before.json")));
    EXPECT_EQ(board.all_settings<msg::ReadParams3>(), edited);
  }
}

}  // namespace
}  // namespace sbgc::test
