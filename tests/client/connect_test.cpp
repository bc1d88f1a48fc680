// Tests of connecting: over every kind of line, and without a board.

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <sbgc/any.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/client/modules.hpp>
#include <sbgc/emulator/uart.hpp>
#include <sbgc/io/pseudo_terminal.hpp>
#include <sbgc/messages.hpp>

#include "emulated_board.hpp"
#include "scripted_board.hpp"
#include "sockets.hpp"

namespace sbgc::test {
namespace {

using std::chrono::steady_clock;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

class Connect : public ::testing::Test {
 protected:
  void SetUp() override { introduce(board); }

  /// Returns the path of a new pseudo-terminal that the board serves.
  std::string serve_pty() {
    auto opened = io::open_pseudo_terminal(board.executor(), {.stays_open = true});
    if (!opened) return {};
    std::string path = opened.transport->path();
    board.serve(std::move(opened.transport));
    return path;
  }

  ScriptedBoard board;
};

/// Returns true if the client receives angles.
bool works(Client& client, ScriptedBoard& board) {
  msg::GetAngles angles;
  angles.axes.yaw.imu_angle = 45_deg;
  board.answer<msg::GetAnglesRequest>(angles);
  const auto answer = client.get_angles();
  return answer && *answer == angles;
}

TEST_F(Connect, OverMemory) {
  auto client = connect_over(over_memory(board), quick());
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_EQ(client->identity().firmware_version(), "2.59");
  EXPECT_EQ(client->identity().board_version(), "3.0");
  EXPECT_EQ(client->identity().serial_number(), "0011223344556677ab");
  EXPECT_TRUE(works(*client, board));
}

TEST_F(Connect, OverAPseudoTerminal) {
  const std::string path = serve_pty();
  auto client = Client::connect(path, quick());
  ASSERT_TRUE(client) << client.error().message;
  // After a stall the line may be found with other settings: this line carries bytes with any
  // settings.
  EXPECT_THAT(client->description(), AllOf(HasSubstr(path), HasSubstr(" 8N1")));
  EXPECT_TRUE(works(*client, board));
}

TEST_F(Connect, WithTheLineOfTheAddress) {
  const std::string path = serve_pty();
  auto client = Client::connect("serial:" + path + "?baud=57600&parity=none", quick());
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_THAT(client->description(), HasSubstr("57600 8N1"));
  EXPECT_TRUE(works(*client, board));
}

TEST_F(Connect, OverTcp) {
  const std::string address =
      accept_once(board.executor(), [this](auto transport) { board.serve(std::move(transport)); });
  auto client = Client::connect(address, quick());
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_TRUE(works(*client, board));
}

TEST_F(Connect, OverUdp) {
  auto client = Client::connect(serve_udp(board), quick());
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_TRUE(works(*client, board));
  const auto refused = client->run(tasks::flash_module(msg::ModuleId::can_drv1, {1, 2, 3, 4}));
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported) << "a line that may repeat packets";
}

TEST_F(Connect, WithThePausesOfTheProtocol) {
  ConnectOptions options = quick();
  options.pacing = true;
  auto client = connect_over(over_memory(board), options);
  ASSERT_TRUE(client) << client.error().message;
  board.ignore<msg::Control>();
  const auto begin = steady_clock::now();
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(client->control({}));
  EXPECT_GE(steady_clock::now() - begin, std::chrono::milliseconds(4 * 10));
}

TEST_F(Connect, UsesTheNewestFramingOfTheFirmware) {
  introduce(board, 2680);
  auto client = connect_over(over_memory(board), quick());
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_EQ(client->statistics().session.framing, Framing::v2);
  EXPECT_TRUE(works(*client, board));
  EXPECT_EQ(board.framing(), Framing::v2);
}

TEST_F(Connect, UsesTheFramingOfEveryBoardWithOldFirmware) {
  introduce(board, 2679);
  auto client = connect_over(over_memory(board), quick());
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_TRUE(works(*client, board));
  EXPECT_EQ(board.framing(), Framing::v1);
  EXPECT_EQ(board.count<msg::BoardInfoRequest>(), 1U) << "no other framing was tried";
}

TEST_F(Connect, UsesTheFramingOfEveryBoardIfTheOtherIsNotAnswered) {
  introduce(board, 2730);
  board.knows_framings_up_to(Framing::v1);
  auto client = connect_over(over_memory(board), quick());
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_EQ(client->statistics().session.framing, Framing::v1);
  EXPECT_TRUE(works(*client, board));
}

TEST_F(Connect, UsesTheFramingOfEveryBoardOnRequest) {
  introduce(board, 2730);
  ConnectOptions options = quick();
  options.newest_framing = false;
  auto client = connect_over(over_memory(board), options);
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_TRUE(works(*client, board));
  EXPECT_EQ(board.framing(), Framing::v1);
}

TEST_F(Connect, RecordsWhatItIsToldTo) {
  const auto file =
      std::filesystem::temp_directory_path() / ("sbgc_connect_test_" + std::to_string(::getpid()));
  ConnectOptions options = quick();
  options.capture = file.string();
  {
    auto client = connect_over(over_memory(board), options);
    ASSERT_TRUE(client) << client.error().message;
  }
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  // CMD_BOARD_INFO and its response, each with its header.
  EXPECT_THAT(content.str(), AllOf(HasSubstr(std::string{'>', 86, 0, 86}),
                                   HasSubstr(std::string{'>', 86, 18, 86 + 18})));
  std::filesystem::remove(file);
  options.capture = "/nonexistent/folder/capture";
  const auto refused = connect_over(over_memory(board), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::io);
}

// Line settings

class ConnectOnLine : public Connect, public ::testing::WithParamInterface<io::LineSettings> {};

TEST_P(ConnectOnLine, FindsTheBoard) {
  // Wrong settings corrupt the bytes in both directions.
  const TransportFactory make = [&](const asio::any_io_executor& executor) {
    auto pair = io::make_memory_pair(executor, board.executor(),
                                     {.with_line = true, .mismatch = emulator::received_as});
    static_cast<void>(pair.second->line()->set(GetParam()));
    board.serve(std::move(pair.second));
    return std::move(pair.first);
  };
  ConnectOptions options = quick();
  options.timeout = std::chrono::seconds(30);
  auto client = connect_over(make, options);
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_THAT(client->description(), HasSubstr(io::to_string(GetParam())));
  EXPECT_TRUE(works(*client, board));
}

INSTANTIATE_TEST_SUITE_P(Lines, ConnectOnLine,
                         ::testing::Values(io::LineSettings{115200, io::Parity::none},
                                           io::LineSettings{115200, io::Parity::even},
                                           io::LineSettings{9600, io::Parity::none},
                                           io::LineSettings{921600, io::Parity::even}));

TEST_F(Connect, SaysAllThatWasTriedWhenALineIsSilent) {
  board.ignore<msg::BoardInfoRequest>();
  ConnectOptions options = quick();
  options.timeout = std::chrono::seconds(5);
  const auto begin = steady_clock::now();
  const auto client = Client::connect(serve_pty(), options);
  EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(60));
  ASSERT_FALSE(client);
  EXPECT_EQ(client.error().code, ErrorCode::not_found);
  EXPECT_THAT(client.error().message,
              AllOf(HasSubstr("no board found on serial port /dev/pts/"), HasSubstr("115200 8N1, "),
                    HasSubstr("9600 8N1, "), HasSubstr("received nothing")));
}

TEST_F(Connect, TellsWhatWasHeardInsteadOfABoard) {
  board.on<msg::BoardInfoRequest>([&](const msg::BoardInfoRequest&) {
    const std::array<std::uint8_t, 5> garbage{1, 2, 3, 4, 5};
    board.send_bytes(garbage);
  });
  ConnectOptions options = quick();
  options.timeout = std::chrono::seconds(5);
  const auto client = Client::connect(serve_pty(), options);
  ASSERT_FALSE(client);
  EXPECT_THAT(client.error().message,
              AllOf(HasSubstr("received at 115200 8N1: "), HasSubstr("no valid frames")));
}

// No board

TEST_F(Connect, FailsWhenNobodyAnswers) {
  board.ignore<msg::BoardInfoRequest>();
  ConnectOptions options = quick();
  options.timeout = std::chrono::seconds(1);
  const auto begin = steady_clock::now();
  const auto client = connect_over(over_memory(board), options);
  EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(60));
  ASSERT_FALSE(client);
  EXPECT_EQ(client.error().code, ErrorCode::not_found);
  EXPECT_THAT(client.error().message,
              AllOf(HasSubstr("no board found on "),
                    ContainsRegex("sent [0-9]+ requests; received nothing")));
}

TEST_F(Connect, FailsWhenTheBoardFallsSilentHalfWay) {
  board.on<msg::BoardInfo3Request>(
      [&](const msg::BoardInfo3Request&) { board.ignore<msg::BoardInfoRequest>(); });
  ConnectOptions options = quick();
  options.retries = 4;
  const auto client = connect_over(over_memory(board), options);
  ASSERT_FALSE(client);
  EXPECT_EQ(client.error().code, ErrorCode::timeout);
  EXPECT_THAT(client.error().message,
              AllOf(HasSubstr("then stopped responding"),
                    AnyOf(HasSubstr("CMD_BOARD_INFO_3"), HasSubstr("blocks the client"))));
}

TEST_F(Connect, DoesWithoutDetailsThatABoardDoesNotTell) {
  board.ignore<msg::BoardInfo3Request>();
  ConnectOptions options = quick();
  options.retries = 4;
  const auto client = connect_over(over_memory(board), options);
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_FALSE(client->identity().details);
  EXPECT_EQ(client->identity().serial_number(), "");
}

TEST_F(Connect, FailsWhenTheLineBreaksMeanwhile) {
  board.on<msg::BoardInfoRequest>([&](const msg::BoardInfoRequest&) { board.unplug(); });
  ConnectOptions options = quick();
  options.timeout = std::chrono::seconds(120);
  const auto begin = steady_clock::now();
  const auto client = connect_over(over_memory(board), options);
  EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(60));
  ASSERT_FALSE(client);
  EXPECT_EQ(client.error().code, ErrorCode::link_lost);
}

TEST(ConnectErrors, AreThoseOfTheLine) {
  const auto unknown = Client::connect("carrier-pigeon:loft", quick());
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::invalid);
  const auto missing = Client::connect("/dev/tty-that-does-not-exist", quick());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::not_found);
  EXPECT_THAT(missing.error().message, HasSubstr("/dev/tty-that-does-not-exist"));
}

/// A board that ignores everything before the password.
emulator::EmulatorOptions protected_board() {
  emulator::EmulatorOptions options = quick_board();
  options.board.password = "sesame";
  return options;
}

ConnectOptions with_password(const std::string& password) {
  ConnectOptions options = quick();
  options.password = password;
  return options;
}

TEST(Password, OpensTheBoardWithTheFirstRequest) {
  std::atomic<bool> is_first = true;
  std::atomic<bool> has_password = false;
  EmulatedBoard board(protected_board());
  board.after([&](const Packet& request) {
    if (is_first.exchange(false)) {
      has_password = holds_secret(Direction::to_board, request.id, request.body);
    }
  });
  auto client = connect_over(board.line(), with_password("sesame"));
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_TRUE(has_password);
  EXPECT_TRUE(client->get_angles());
}

TEST(Password, IsSentAtEachRateThatASearchTries) {
  EmulatedBoard board(protected_board());
  const std::string path = board.serve_terminal();
  if (path.empty()) GTEST_SKIP() << "no terminals here";
  auto client = Client::connect(path, with_password("sesame"));
  ASSERT_TRUE(client) << client.error().message;
  EXPECT_TRUE(client->get_angles());
  const auto none = Client::connect(path, quick());
  EXPECT_FALSE(none);
}

TEST(Password, ThatIsWrongOrMissingFindsNoBoardAndIsNotTold) {
  EmulatedBoard board(protected_board());
  const auto wrong = connect_over(board.line(), with_password("open, please"));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, ErrorCode::not_found);
  EXPECT_THAT(wrong.error().message, HasSubstr("a port that wants another password"));
  EXPECT_THAT(wrong.error().message, ::testing::Not(HasSubstr("open, please")));
  EXPECT_FALSE(connect_over(board.line(), quick()));
}

TEST(Password, ThatCannotBeOneIsRefusedBeforeAnythingIsSent) {
  for (const std::string& text : {std::string(), std::string(33, 'x'), std::string("a\nb")}) {
    const auto client = Client::connect("tcp:127.0.0.1:1", with_password(text));
    ASSERT_FALSE(client);
    EXPECT_EQ(client.error().code, ErrorCode::invalid);
    EXPECT_EQ(client.error().message, "a password has 1 to 32 bytes, and no control characters");
  }
}

}  // namespace
}  // namespace sbgc::test
