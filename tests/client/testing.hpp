/// Helpers for the tests of the client: names, results, waiting, and clients of a board.
#pragma once

#include <cstddef>
#include <fstream>
#include <limits>
#include <random>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/client/client.hpp>
#include <sbgc/client/clock.hpp>

#include "emulated_board.hpp"
#include "scripted_board.hpp"
#include "temporary_folder.hpp"

namespace sbgc::test {

/// A clock that advances only on request.
///
/// A sleeping thread advances the time; a waiting thread wakes up when another one advances it.
class ManualClock final : public Clock {
 public:
  TimePoint now() override {
    const std::scoped_lock lock(mutex_);
    return now_;
  }
  void sleep_until(TimePoint until) override { move_to(until); }
  void wait_until(std::unique_lock<std::mutex>& lock, std::condition_variable& changed,
                  TimePoint until) override {
    Waiter waiter{lock.mutex(), &changed};
    {
      const std::scoped_lock own(mutex_);
      if (now_ >= until) return;
      waiters_.insert(waiter);
    }
    // advance() locks the mutex of a waiter before it notifies, so no notification is missed.
    changed.wait(lock);
    const std::scoped_lock own(mutex_);
    waiters_.erase(waiters_.find(waiter));
  }

  /// Calls `follow` with each advance before the new time is visible. Must be called before threads
  /// start.
  void on_move(std::function<void(std::chrono::milliseconds)> follow) {
    follow_ = std::move(follow);
  }
  void advance(std::chrono::milliseconds duration) { move_to(now() + duration); }

 private:
  using Waiter = std::pair<std::mutex*, std::condition_variable*>;

  void move_to(TimePoint time) {
    std::multiset<Waiter> waiters;
    const TimePoint before = now();
    if (follow_ && time > before) {
      follow_(std::chrono::ceil<std::chrono::milliseconds>(time - before));
    }
    {
      const std::scoped_lock lock(mutex_);
      now_ = std::max(now_, time);
      waiters = waiters_;
    }
    for (const auto& [mutex, changed] : waiters) {
      const std::scoped_lock lock(*mutex);
      changed->notify_all();
    }
  }

  std::function<void(std::chrono::milliseconds)> follow_{};
  std::mutex mutex_;
  TimePoint now_{std::chrono::hours(1)};
  std::multiset<Waiter> waiters_;
};

/// Collects the arguments of handler calls, from any thread.
template <class T>
class Collector {
 public:
  void add(const T& item) {
    const std::lock_guard lock(mutex_);
    items_.push_back(item);
    added_.notify_all();
  }

  /// Waits until there are `count` items and returns them; returns fewer only after a failure.
  std::vector<T> wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(
        added_.wait_for(lock, std::chrono::seconds(60), [&] { return items_.size() >= count; }))
        << items_.size() << " of " << count << " items";
    return items_;
  }

  void clear() {
    const std::lock_guard lock(mutex_);
    items_.clear();
  }

  /// Waits until `done(items)` is true.
  template <class Done>
  bool wait_until(Done done) {
    std::unique_lock lock(mutex_);
    return added_.wait_for(lock, std::chrono::seconds(60), [&] { return done(items_); });
  }

 private:
  std::mutex mutex_;
  std::condition_variable added_;
  std::vector<T> items_;
};

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::Eq;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

using Ms = std::chrono::milliseconds;

/// Returns a result; throws its error, which fails the test.
template <class R>
R checked(R result) {
  if (!result) throw std::runtime_error(result.error().message);
  return result;
}

/// Throws the error of a result, which fails the test.
template <class R>
void require(const R& result) {
  if (!result) throw std::runtime_error(result.error().message);
}

/// Returns the error of a result, or of a report of writing.
template <class R>
const ClientError& error_of(const R& result) {
  if constexpr (requires { result.outcome; }) {
    return result.outcome.error();
  } else {
    return result.error();
  }
}

MATCHER_P2(IsFailure, code, message, "") {
  if (arg) {
    *result_listener << "which is a success";
    return false;
  }
  const ClientError& error = error_of(arg);
  *result_listener << "which is " << ::testing::PrintToString(error.code) << ": " << error.message;
  return error.code == code && ::testing::Matches(message)(error.message);
}

/// Matches a result that is an error, with this in its message.
inline auto fails(ErrorCode code, const char* part = "") {
  return IsFailure(code, ::testing::Matcher<const std::string&>(HasSubstr(part)));
}
inline auto fails(ErrorCode code, const ::testing::Matcher<const std::string&>& message) {
  return IsFailure(code, message);
}

/// Waits until `done()` is true.
template <class Done>
void wait_until(Done done) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!done()) {
    if (std::chrono::steady_clock::now() > end) throw std::runtime_error("it never happens");
    std::this_thread::sleep_for(Ms(1));
  }
}

/// Collects the samples of a stream, or the messages of a kind.
template <class M>
Subscription stream_into(Collector<M>& samples, Client& client, Ms interval) {
  return *checked(client.stream<M>(interval, [&](const M& one) { samples.add(one); }));
}
template <class M>
Subscription subscribe_into(Collector<M>& messages, Client& client) {
  return client.subscribe<M>([&](const M& one) { messages.add(one); });
}

/// Options of a client that connects again at once.
inline ReconnectOptions quick_again(OutagePolicy calls = OutagePolicy::fail) {
  ReconnectOptions options;
  options.connection = quick();
  options.connection.detect_line = false;
  options.first_pause = Ms(1);
  options.longest_pause = Ms(5);
  options.longest_silence = Ms(0);
  options.calls = calls;
  return options;
}

/// A test with a scripted board, which introduces itself.
class ScriptedTest : public ::testing::Test {
 protected:
  ScriptedTest() { introduce(board); }

  Client connect(const ConnectOptions& options = quick()) {
    return *checked(connect_over(over_line(board), options));
  }
  /// Returns when all frames sent so far have been handled.
  void settle(Client& client) {
    board.answer<msg::CalibInfoRequest>(msg::CalibInfo{});
    EXPECT_TRUE(client.calib_info());
  }
  /// Confirms and records every registration of a stream.
  void serve_streams() {
    board.on<msg::DataStreamInterval>([this](const msg::DataStreamInterval& request) {
      registrations.add(request);
      board.confirm(request);
    });
  }
  /// Waits until a stream has been ended.
  bool is_stream_ended() {
    return registrations.wait_until([](const auto& requests) {
      return !requests.empty() && requests.back().interval_ms == msg::Milliseconds{};
    });
  }

  /// For calls that are counted.
  const CallOptions once{.timeout = std::chrono::seconds(10), .retries = 0};
  Collector<msg::DataStreamInterval> registrations;
  ScriptedBoard board;
};

/// A test with an emulated board at a cable that can be pulled.
class CableTest : public ::testing::Test {
 protected:
  /// Returns lines to the board as long as the cable is plugged in.
  TransportFactory cable() {
    return [this, line = board.line()](const asio::any_io_executor& executor) {
      ++attempts;
      return is_plugged ? line(executor) : nullptr;
    };
  }
  void watch(const LinkChange& change) { changes.add(change); }
  void pull() {
    is_plugged = false;
    board.unplug();
    ASSERT_TRUE(wait_for(LinkState::searching));
  }
  void plug() {
    is_plugged = true;
    ASSERT_TRUE(wait_for(LinkState::connected));
  }
  bool wait_for(LinkState state) {
    return changes.wait_until(
        [&](const auto& all) { return std::ranges::count(all, state, &LinkChange::state) != 0; });
  }
  std::vector<LinkState> states() {
    std::vector<LinkState> result;
    for (const LinkChange& one : changes.wait_for(0)) result.push_back(one.state);
    return result;
  }
  /// Waits until the board has received `count` requests M.
  template <class M>
  void wait_for_requests(std::size_t count) {
    sbgc::test::wait_until([&] { return board.count<M>() >= count; });
  }

  /// Waits for five samples more.
  template <class M>
  void expect_samples(Collector<M>& samples) {
    const std::size_t before = samples.wait_for(0).size();
    board.skip(Ms(200));
    samples.wait_for(before + 5);
  }

  EmulatedBoard board;
  std::atomic<bool> is_plugged = true;
  std::atomic<int> attempts = 0;
  Collector<LinkChange> changes;
};

}  // namespace sbgc::test
