// Tests of connecting: over every kind of line, and without a board.

#include <unistd.h>

#include <sbgc/any.hpp>
#include <sbgc/client/modules.hpp>
#include <sbgc/emulator/uart.hpp>

#include "testing.hpp"

namespace sbgc::test {
namespace {

using std::chrono::steady_clock;

class Connect : public ScriptedTest {
 protected:
  /// Returns the path of a new pseudo-terminal that the board serves.
  std::string serve_pty() {
    auto opened = io::open_pseudo_terminal(board.executor(), {.stays_open = true});
    if (!opened) return {};
    std::string path = opened.transport->path();
    board.serve(std::move(opened.transport));
    return path;
  }
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
  auto client = checked(connect_over(over_memory(board), quick()));
  EXPECT_EQ(client->identity().firmware_version(), "2.59");
  EXPECT_EQ(client->identity().board_version(), "3.0");
  EXPECT_EQ(client->identity().serial_number(), "0011223344556677ab");
  EXPECT_TRUE(works(*client, board));
}

TEST_F(Connect, OverAPseudoTerminal) {
  const std::string path = serve_pty();
  auto client = checked(Client::connect(path, quick()));
  // After a stall the line may be found with other settings: this line carries bytes with any
  // settings.
  EXPECT_THAT(client->description(), AllOf(HasSubstr(path), HasSubstr(" 8N1")));
  EXPECT_TRUE(works(*client, board));
}

TEST_F(Connect, WithTheLineOfTheAddress) {
  const std::string path = serve_pty();
  auto client = checked(Client::connect("serial:" + path + "?baud=57600&parity=none", quick()));
  EXPECT_THAT(client->description(), HasSubstr("57600 8N1"));
  EXPECT_TRUE(works(*client, board));
}

TEST_F(Connect, OverTcp) {
  const std::string address =
      accept_once(board.executor(), [this](auto transport) { board.serve(std::move(transport)); });
  auto client = checked(Client::connect(address, quick()));
  EXPECT_TRUE(works(*client, board));
}

TEST_F(Connect, OverUdp) {
  auto client = checked(Client::connect(serve_udp(board), quick()));
  EXPECT_TRUE(works(*client, board));
  const auto refused = client->run(tasks::flash_module(msg::ModuleId::can_drv1, {1, 2, 3, 4}));
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported) << "a line that may repeat packets";
}

TEST_F(Connect, WithThePausesOfTheProtocol) {
  ConnectOptions options = quick();
  options.pacing = true;
  auto client = checked(connect_over(over_memory(board), options));
  board.ignore<msg::Control>();
  const auto begin = steady_clock::now();
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(client->control({}));
  EXPECT_GE(steady_clock::now() - begin, Ms(4 * 10));
}

TEST_F(Connect, UsesTheNewestFramingThatTheBoardAnswers) {
  struct Case {
    std::uint16_t firmware;
    Framing known;
    bool is_wanted;
    Framing used;
  };
  for (const Case& one : {Case{2680, Framing::v2, true, Framing::v2},
                          {2679, Framing::v2, true, Framing::v1},
                          {2730, Framing::v1, true, Framing::v1},
                          {2730, Framing::v2, false, Framing::v1}}) {
    introduce(board, one.firmware);
    board.knows_framings_up_to(one.known);
    ConnectOptions options = quick();
    options.newest_framing = one.is_wanted;
    const std::size_t before = board.count<msg::BoardInfoRequest>();
    auto client = checked(connect_over(over_memory(board), options));
    EXPECT_EQ(client->statistics().session.framing, one.used);
    EXPECT_TRUE(works(*client, board));
    EXPECT_EQ(board.framing(), one.used);
    if (one.firmware == 2679) {
      EXPECT_EQ(board.count<msg::BoardInfoRequest>(), before + 1) << "no other framing was tried";
    }
  }
}

TEST_F(Connect, RecordsWhatItIsToldTo) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "capture";
  ConnectOptions options = quick();
  options.capture = file.string();
  { require(connect_over(over_memory(board), options)); }
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  // CMD_BOARD_INFO and its response, each with its header.
  EXPECT_THAT(content.str(), AllOf(HasSubstr(std::string{'>', 86, 0, 86}),
                                   HasSubstr(std::string{'>', 86, 18, 86 + 18})));
  options.capture = "/nonexistent/folder/capture";
  EXPECT_THAT(connect_over(over_memory(board), options), fails(ErrorCode::io));
}

TEST_F(Connect, SaysAllThatWasTriedWhenALineIsSilent) {
  board.ignore<msg::BoardInfoRequest>();
  ConnectOptions options = quick();
  options.timeout = std::chrono::seconds(5);
  const auto client = Client::connect(serve_pty(), options);
  EXPECT_THAT(client, fails(ErrorCode::not_found,
                            AllOf(HasSubstr("no board found on serial port /dev/pts/"),
                                  HasSubstr("115200 8N1, "), HasSubstr("9600 8N1, "),
                                  HasSubstr("received nothing"))));
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
  EXPECT_THAT(client, fails(ErrorCode::not_found,
                            AllOf(HasSubstr("no board found on "),
                                  ContainsRegex("sent [0-9]+ requests; received nothing"))));
}

TEST_F(Connect, FailsWhenTheBoardFallsSilentHalfWay) {
  board.on<msg::BoardInfo3Request>(
      [&](const msg::BoardInfo3Request&) { board.ignore<msg::BoardInfoRequest>(); });
  ConnectOptions options = quick();
  options.retries = 4;
  EXPECT_THAT(connect_over(over_memory(board), options),
              fails(ErrorCode::timeout,
                    AllOf(HasSubstr("then stopped responding"),
                          AnyOf(HasSubstr("CMD_BOARD_INFO_3"), HasSubstr("blocks the client")))));
}

TEST_F(Connect, DoesWithoutDetailsThatABoardDoesNotTell) {
  board.ignore<msg::BoardInfo3Request>();
  ConnectOptions options = quick();
  options.retries = 4;
  const auto client = checked(connect_over(over_memory(board), options));
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
  EXPECT_THAT(client, fails(ErrorCode::link_lost));
}

TEST(ConnectErrors, AreThoseOfTheLine) {
  EXPECT_THAT(Client::connect("carrier-pigeon:loft", quick()), fails(ErrorCode::invalid));
  EXPECT_THAT(Client::connect("/dev/tty-that-does-not-exist", quick()),
              fails(ErrorCode::not_found, "/dev/tty-that-does-not-exist"));
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
  auto client = checked(connect_over(board.line(), with_password("sesame")));
  EXPECT_TRUE(has_password);
  EXPECT_TRUE(client->get_angles());
}

TEST(Password, IsSentAtEachRateThatASearchTries) {
  EmulatedBoard board(protected_board());
  const std::string path = board.serve_terminal();
  if (path.empty()) GTEST_SKIP() << "no terminals here";
  auto client = checked(Client::connect(path, with_password("sesame")));
  EXPECT_TRUE(client->get_angles());
  const auto none = Client::connect(path, quick());
  EXPECT_FALSE(none);
}

TEST(Password, ThatIsWrongOrMissingFindsNoBoardAndIsNotTold) {
  EmulatedBoard board(protected_board());
  EXPECT_THAT(connect_over(board.line(), with_password("open, please")),
              fails(ErrorCode::not_found, AllOf(HasSubstr("a port that wants another password"),
                                                Not(HasSubstr("open, please")))));
  EXPECT_FALSE(connect_over(board.line(), quick()));
}

TEST(Password, ThatCannotBeOneIsRefusedBeforeAnythingIsSent) {
  for (const std::string& text : {std::string(), std::string(33, 'x'), std::string("a\nb")}) {
    EXPECT_THAT(
        Client::connect("tcp:127.0.0.1:1", with_password(text)),
        fails(ErrorCode::invalid, Eq("a password has 1 to 32 bytes, and no control characters")));
  }
}

}  // namespace
}  // namespace sbgc::test
