// Tests of saving the memory of several boards in one process.

#include "serving/state_keeper.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <asio/io_context.hpp>
#include <gtest/gtest.h>

#include <sbgc/message.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/parser.hpp>

namespace sbgc::serving {
namespace {

constexpr auto patience = std::chrono::seconds(60);

emulator::EmulatorOptions options() { return {.board = {.waits_for_saving = true}}; }

/// A simulated disk that completes writes on request.
class Disk {
 public:
  StateKeeper::Save save() {
    return [this](const SavedMemory& saved) -> Result<void> {
      std::future<Result<void>> result;
      {
        const std::lock_guard lock(mutex_);
        if (is_quick_) return {};
        result = results_.emplace_back().get_future();
        memories_.push_back(saved.memory);
      }
      return result.get();
    };
  }

  void be_slow() {
    const std::lock_guard lock(mutex_);
    is_quick_ = false;
  }
  std::size_t begun() {
    const std::lock_guard lock(mutex_);
    return results_.size();
  }
  emulator::Memory memory(std::size_t number) {
    const std::lock_guard lock(mutex_);
    return memories_[number];
  }
  void end(std::size_t number, const Result<void>& result = {}) {
    const std::lock_guard lock(mutex_);
    results_[number].set_value(result);
  }

 private:
  std::mutex mutex_;
  bool is_quick_ = true;
  std::vector<std::promise<Result<void>>> results_;
  std::vector<emulator::Memory> memories_;
};

/// A board with its disk and a host.
struct Kept {
  Kept(asio::io_context& context, asio::thread_pool& pool)
      : board(context.get_executor(), options(), {}),
        keeper(context.get_executor(), pool, board, disk.save(),
               [this](const std::string& problem) { warnings.push_back(problem); }),
        port(*board.connect(false, [this] { take(); })) {
    board.on_memory_changed = [this] { keeper.changed(); };
    disk.be_slow();
  }

  template <Message M>
  void send(const M& message) {
    std::array<std::uint8_t, max_frame_size> frame{};
    const WriteResult written = encode_frame(message, frame);
    board.receive(port, std::span(frame).first(written.size));
  }

  void write(std::uint8_t first) {
    msg::WriteExternalData request;
    request.data[0] = first;
    send(request);
  }

  void take() {
    const auto bytes = board.output(port);
    parser.feed(bytes, [&](const Frame& frame) { heard.push_back(frame.id); });
    if (!bytes.empty()) board.take(port, bytes.size());
  }

  Disk disk{};
  LiveBoard board;
  std::vector<std::string> warnings{};
  StateKeeper keeper;
  ParserOfAll parser{};
  std::vector<std::uint8_t> heard{};  // ids of frames
  std::size_t port;
};

struct KeeperRig {
  asio::io_context context{1};
  asio::thread_pool pool{2};

  void run_until(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + patience;
    context.restart();
    while (!done()) {
      ASSERT_LT(std::chrono::steady_clock::now(), end);
      context.run_one_for(std::chrono::milliseconds(10));
    }
  }
};

constexpr auto confirm = static_cast<std::uint8_t>(msg::Confirm::command);
constexpr auto board_info = static_cast<std::uint8_t>(msg::BoardInfo::command);
constexpr auto error = static_cast<std::uint8_t>(msg::ErrorExt::command);

using Ids = std::vector<std::uint8_t>;

TEST(StateKeeper, OtherBoardsAreServedWhileOneIsSaved) {
  KeeperRig rig;
  Kept saved(rig.context, rig.pool);
  Kept other(rig.context, rig.pool);
  saved.write(1);
  rig.run_until([&] { return saved.disk.begun() == 1; });
  for (int i = 0; i < 100; ++i) {
    other.heard.clear();
    other.send(msg::BoardInfoRequest{});
    rig.run_until([&] { return !other.heard.empty(); });
    EXPECT_EQ(other.heard, Ids{board_info});
  }
  EXPECT_TRUE(saved.heard.empty());
  saved.disk.end(0);
  rig.run_until([&] { return !saved.heard.empty(); });
  EXPECT_EQ(saved.heard, Ids{confirm});
  EXPECT_TRUE(saved.keeper.finish());
}

TEST(StateKeeper, WhatChangesMeanwhileIsSavedNextAndAtOnce) {
  KeeperRig rig;
  Kept kept(rig.context, rig.pool);
  kept.write(1);
  rig.run_until([&] { return kept.disk.begun() == 1; });
  const auto revision = kept.board.memory().revision;
  for (std::uint8_t value = 2; value <= 4; ++value) kept.write(value);
  rig.run_until([&] { return kept.board.memory().revision == revision + 3; });
  EXPECT_EQ(kept.disk.begun(), 1U);
  kept.disk.end(0);
  rig.run_until([&] { return kept.disk.begun() == 2; });
  EXPECT_EQ(kept.heard, Ids{confirm});
  EXPECT_EQ(kept.disk.memory(1).eeprom, kept.board.memory().eeprom);
  kept.disk.end(1);
  rig.run_until([&] { return kept.heard.size() == 4; });
  EXPECT_EQ(kept.disk.begun(), 2U);
}

TEST(StateKeeper, AFailureIsToldAndTriedAgain) {
  KeeperRig rig;
  Kept kept(rig.context, rig.pool);
  kept.write(1);
  rig.run_until([&] { return kept.disk.begun() == 1; });
  kept.disk.end(0, ClientError{ErrorCode::io, "the disk is full"});
  rig.run_until([&] { return !kept.heard.empty(); });
  EXPECT_EQ(kept.heard, Ids{error});
  EXPECT_EQ(kept.warnings, std::vector<std::string>{"the disk is full"});
  kept.write(1);  // again
  rig.run_until([&] { return kept.disk.begun() == 2; });
  EXPECT_EQ(kept.heard, Ids{error}) << "the contents of the memory are not saved";
  kept.disk.end(1);
  rig.run_until([&] { return kept.heard.size() == 2; });
  EXPECT_EQ(kept.heard, (Ids{error, confirm}));
  EXPECT_TRUE(kept.keeper.finish());
}

TEST(StateKeeper, TheEndWaitsForWhatIsBeingSaved) {
  KeeperRig rig;
  Kept kept(rig.context, rig.pool);
  kept.write(1);
  rig.run_until([&] { return kept.disk.begun() == 1; });
  kept.write(2);
  const auto revision = kept.board.memory().revision;
  rig.run_until([&] { return kept.board.memory().revision != revision; });
  auto finished = std::async(std::launch::async, [&] { return kept.keeper.finish(); });
  kept.disk.end(0);
  while (kept.disk.begun() != 2) std::this_thread::yield();
  EXPECT_EQ(kept.disk.memory(1).eeprom, kept.board.memory().eeprom);
  kept.disk.end(1, ClientError{ErrorCode::io, "the disk is full"});
  EXPECT_FALSE(finished.get());
}

TEST(StateKeeper, AFileThatCannotBeWrittenIsToldAtTheBeginning) {
  KeeperRig rig;
  LiveBoard board(rig.context.get_executor(), options(), {});
  const auto make = [&] {
    StateKeeper(rig.context.get_executor(), rig.pool, board,
                [](const SavedMemory&) -> Result<void> {
                  return ClientError{ErrorCode::io, "cannot write"};
                },
                {});
  };
  EXPECT_THROW(make(), std::runtime_error);
}

}  // namespace
}  // namespace sbgc::serving
