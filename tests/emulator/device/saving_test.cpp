// Before its memory is saved, a board confirms no change to it.

#include <cstdint>
#include <vector>

#include "host.hpp"
#include "random_input.hpp"

namespace sbgc::test {
namespace {

/// A host receives the same responses in the same order, whenever the memory is saved.
TEST(Saving, ChangesNothingButWhen) {
  int waited = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    std::vector<Bytes> heard[2];
    for (const bool waits : {false, true}) {
      RandomRequests requests(seed);
      emulator::BoardOptions options = seed % 2 == 0 ? emulator::BoardOptions{} : newest_board();
      options.waits_for_saving = waits;
      options.output_buffer = 0;
      emulator::Board board(options, {}, Instant{});
      const std::vector<std::size_t> ports{board.open_port().value(), board.open_port().value()};
      heard[waits].resize(ports.size());
      Instant now = Instant{} + seconds(1);
      const auto collect = [&] {
        for (const std::size_t port : ports) {
          const auto bytes = board.output(port);
          heard[waits][port].insert(heard[waits][port].end(), bytes.begin(), bytes.end());
          board.sent(port, bytes.size(), now);
        }
      };
      for (int i = 0; i < 400; ++i) {
        const std::size_t port = requests.up_to(1);
        const Bytes bytes = requests.next();
        const std::uint32_t pause = requests.up_to(20);
        const bool is_saved = requests.up_to(3) == 0;
        board.receive(port, bytes, now);
        now = now + milliseconds(pause);
        board.advance(now);
        waited += board.memory().is_unsaved ? 1 : 0;
        if (is_saved) board.memory_saved(board.memory().revision, now);
        collect();
      }
      board.memory_saved(board.memory().revision, now);
      collect();
    }
    EXPECT_EQ(heard[0], heard[1]) << seed;
  }
  EXPECT_GT(waited, 100);
}

}  // namespace
}  // namespace sbgc::test
