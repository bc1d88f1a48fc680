// Precautions of the examples that move a gimbal: they ask first, stop on Ctrl-C, and leave the
// motors as they found them.

#pragma once

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

#include <sbgc/client/client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/realtime.hpp>

namespace careful {

/// Returns true if moving is already confirmed, or the user types "yes".
inline bool may_move(bool is_accepted, const char* what) {
  if (is_accepted) return true;
  std::printf("%s\nIs the gimbal fastened and balanced, and its range free? Type yes to continue: ",
              what);
  std::fflush(stdout);
  std::array<char, 8> answer{};
  const bool is_read = std::fgets(answer.data(), static_cast<int>(answer.size()), stdin) != nullptr;
  if (is_read && std::strcmp(answer.data(), "yes\n") == 0) return true;
  std::printf("\nnothing has been moved\n");
  return false;
}

/// The same for a turn to a pitch angle: says where it ends, and which way the camera turns. `also`
/// is what else happens.
inline bool may_tilt(bool is_accepted, sbgc::Client& client, sbgc::msg::Angle14 to,
                     const char* also = "") {
  const auto state = client.get_angles();
  if (!state) return std::fprintf(stderr, "%s\n", state.error().message.c_str()), false;
  const auto way = [](double degrees) { return degrees < 0 ? "up" : "down"; };
  const double end = to.degrees();
  const double now = std::round(state->axes.pitch.imu_angle.degrees()) + 0.0;  // no -0
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(),
                "%sThe camera turns to %.0f deg %s (now %.0f %s: %s by %.0f).", also, std::abs(end),
                way(end), std::abs(now), way(now), way(end - now), std::abs(end - now));
  return may_move(is_accepted, text.data());
}

/// Removes a last argument --yes. Returns true if it was present.
inline bool take_yes_flag(int& argc, char** argv) {
  const bool exists = argc > 1 && std::strcmp(argv[argc - 1], "--yes") == 0;
  if (exists) --argc;
  return exists;
}

// NOLINTNEXTLINE(*-avoid-non-const-global-variables): a signal handler needs it
inline volatile std::sig_atomic_t signalled = 0;

/// Makes Ctrl-C, and closing the terminal, set a flag instead of ending the program, so that it can
/// stop the camera first. They also end a printf() that waits for its reader, and what is printed
/// later is discarded.
inline void notice_signals() {
  static const int nowhere = ::open("/dev/null", O_WRONLY);
  struct sigaction action {};
  action.sa_handler = [](int) {
    signalled = 1;
    ::dup2(nowhere, STDOUT_FILENO);
  };
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
}

/// For move_to(): returns false after a signal, which stops the camera.
inline bool go_on(const sbgc::MoveProgress&) { return signalled == 0; }

/// Turns the motors off in its destructor if it turned them on, whatever the reason for leaving.
class Motors {
 public:
  explicit Motors(sbgc::Client& client) : client_(client) {}
  Motors(const Motors&) = delete;
  Motors& operator=(const Motors&) = delete;
  Motors(Motors&&) = delete;
  Motors& operator=(Motors&&) = delete;
  ~Motors() {
    if (!turned_on_) return;
    // Nothing is printed before, because a printf() can wait for its reader.
    if (auto off = client_.motors_off(); !off) {
      std::fprintf(stderr, "turning the motors off: %s\n", off.error().message.c_str());
    } else {
      std::printf("turned the motors off again\n");
    }
  }

  sbgc::Result<void> turn_on() {
    const auto state = client_.realtime_data_4();
    if (!state) return state.error();
    if (state->other_flags.has(sbgc::msg::OtherFlag::motors_on)) return {};
    turned_on_ = true;  // even without a confirmation, as they may be on
    const auto on = client_.motors_on();
    if (!on) return on.error();
    return {};
  }

 private:
  sbgc::Client& client_;
  bool turned_on_ = false;
};

}  // namespace careful
