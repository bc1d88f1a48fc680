// What the examples do before and while they move a gimbal: they ask, they notice Ctrl-C, and they
// leave the motors as they have found them.

#pragma once

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <sbgc/client/client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>

namespace careful {

/// Whether the gimbal may move: that is agreed already, or somebody types "yes".
inline bool may_move(bool is_agreed, const char* what) {
  if (is_agreed) return true;
  std::printf("%s\nIs it fastened, balanced, and nobody in its way? Type yes to go on: ", what);
  std::fflush(stdout);
  std::array<char, 8> answer{};
  const bool is_read = std::fgets(answer.data(), static_cast<int>(answer.size()), stdin) != nullptr;
  if (is_read && std::strcmp(answer.data(), "yes\n") == 0) return true;
  std::printf("\nnothing has been moved\n");
  return false;
}

/// Whether the last argument is --yes, which is then taken off.
inline bool take_yes(int& argc, char** argv) {
  const bool is_there = argc > 1 && std::strcmp(argv[argc - 1], "--yes") == 0;
  if (is_there) --argc;
  return is_there;
}

inline volatile std::sig_atomic_t signalled = 0;

/// From now on Ctrl-C, or a terminal that is closed, does not end the program at once: it has a
/// camera to stop.
inline void notice_signals() {
  for (const int signal : {SIGHUP, SIGINT, SIGTERM})
    std::signal(signal, [](int) { signalled = 1; });
}

/// For move_to(): goes on until a signal has come; the camera is stopped then.
inline bool go_on(const sbgc::MoveProgress&) { return signalled == 0; }

/// Motors that are turned off again at the end, whatever the reason for it, if they were off
/// before.
class Motors {
 public:
  explicit Motors(sbgc::Client& client) : client_(client) {}
  Motors(const Motors&) = delete;
  Motors& operator=(const Motors&) = delete;
  Motors(Motors&&) = delete;
  Motors& operator=(Motors&&) = delete;
  ~Motors() {
    if (!turned_on_) return;
    std::printf("the motors are turned off again, as they were\n");
    if (auto off = client_.motors_off(); !off) {
      std::fprintf(stderr, "turning the motors off: %s\n", off.error().message.c_str());
    }
  }

  sbgc::Result<void> turn_on() {
    const auto state = client_.realtime_data_4();
    if (!state) return state.error();
    if (state->other_flags.has(sbgc::msg::OtherFlag::motors_on)) return {};
    turned_on_ = true;  // also if no confirmation comes: they may be on
    const auto on = client_.motors_on();
    if (!on) return on.error();
    return {};
  }

 private:
  sbgc::Client& client_;
  bool turned_on_ = false;
};

}  // namespace careful
