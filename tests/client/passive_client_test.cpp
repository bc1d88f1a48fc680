// Tests of a client without threads that finds its line and its framing.

#include <sbgc/client/passive_client.hpp>
#include <sbgc/emulator/emulator.hpp>

#include "testing.hpp"

namespace sbgc::test {
namespace {

/// A line on which bytes pass only at the settings of the board.
class Search : public ::testing::Test {
 protected:
  static constexpr LineSettings board_line{57600, Parity::even};

  /// Runs the client until `result`.
  Result<void> finish(const std::optional<Result<void>>& result) {
    while (!result) {
      if (const auto bytes = client.advance(now); !bytes.empty()) {
        if (line == board_line) board.from_host(port, bytes, now);
        client.written(now);
      }
      board.advance(now);
      if (const auto bytes = board.to_host(port); !bytes.empty()) {
        client.receive(bytes, now);
        board.take(port, bytes.size(), now);
      }
      now = later(earlier(client.deadline(), board.next()), now + microseconds(1));
    }
    return *result;
  }
  Result<void> search() {
    std::optional<Result<void>> result;
    client.detect_line(
        [&](const LineSettings& wanted) {
          line = wanted;
          return wanted.baud_rate != refused_rate;
        },
        [&](const Result<void>& found) { result = found; });
    return finish(result);
  }

  Instant now{};
  LineSettings line{};
  std::uint32_t refused_rate = 115200;
  emulator::Emulator board{{.board = {.firmware = msg::FirmwareVersion(2730)}}, {}, now};
  std::size_t port = board.connect(true, now).value();
  PassiveClient client{};
};

TEST_F(Search, FindsTheLineThenTheNewestFraming) {
  require(search());
  EXPECT_EQ(line, board_line);

  std::optional<Result<void>> connected;
  std::optional<Framing> last;
  const Subscription frames =
      client.on_frame([&](const BoardFrame& one) { last = one.frame.framing; });
  client.connect([&](const Result<void>& result) { connected = result; });
  ASSERT_TRUE(finish(connected));
  EXPECT_NE(newest_framing(client.identity().versions()), basic_framing);
  EXPECT_EQ(last, newest_framing(client.identity().versions()));
}

TEST_F(Search, FailsWhereNoSettingsServe) {
  refused_rate = board_line.baud_rate;
  EXPECT_THAT(search(), fails(ErrorCode::not_found));
}

}  // namespace
}  // namespace sbgc::test
