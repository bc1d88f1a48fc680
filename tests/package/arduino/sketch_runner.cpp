// Runs a sketch on a board of which Serial1 is wired to an emulated gimbal and Serial to a user:
//
//     sketch_runner SECONDS [TEXT [silent]]
//
// The user types TEXT after one second; a silent gimbal neither receives nor sends. Prints what the
// sketch writes to Serial, and at the end where the camera looks: by the angles of its motors, as
// its frame is level. Time is simulated.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <span>
#include <string_view>

#include <sbgc/emulator/board.hpp>
#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/time.hpp>

#include "Arduino.h"

namespace {

constexpr sbgc::Duration step = sbgc::milliseconds(1);

sbgc::Instant now;
sbgc::emulator::Board gimbal({}, {}, now);
std::size_t port;
std::deque<std::uint8_t> typed;
std::deque<std::uint8_t> from_gimbal;

std::deque<std::uint8_t>& input(const HardwareSerial* serial) {
  return serial == &Serial ? typed : from_gimbal;
}

void run(sbgc::Duration time) {
  for (const sbgc::Instant end = now + time; now < end; now = now + step) {
    gimbal.advance(now);
    const std::span<const std::uint8_t> bytes = gimbal.output(port);
    from_gimbal.insert(from_gimbal.end(), bytes.begin(), bytes.end());
    gimbal.sent(port, bytes.size(), now);
    loop();
  }
}

/// A motor of pitch with a positive angle turns the front down; it is carried by that of roll.
double degrees_down() {
  constexpr double radian = 3.14159265358979323846 / 180;
  const auto& motors = gimbal.gimbal().sample(now).joints;
  return std::asin(std::sin(motors.pitch * radian) * std::cos(motors.roll * radian)) / radian;
}

}  // namespace

HardwareSerial Serial;
HardwareSerial Serial1;

unsigned long millis() { return static_cast<unsigned long>(now.us / 1000); }
unsigned long micros() { return static_cast<unsigned long>(now.us); }

void HardwareSerial::begin(unsigned long) {}
int HardwareSerial::available() { return static_cast<int>(input(this).size()); }
int HardwareSerial::read() {
  if (input(this).empty()) return -1;
  const int first = input(this).front();
  input(this).pop_front();
  return first;
}
std::size_t HardwareSerial::write(const std::uint8_t* bytes, std::size_t size) {
  if (this == &Serial1) gimbal.receive(port, {bytes, size}, now);
  return size;
}
void HardwareSerial::print(const char* text) { std::fputs(text, stdout); }
void HardwareSerial::print(double number, int digits) { std::printf("%.*f", digits, number); }
void HardwareSerial::println(const char* text) { std::printf("%s\n", text); }
void HardwareSerial::println(double number, int digits) { std::printf("%.*f\n", digits, number); }

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  gimbal.advance(now = now + sbgc::seconds(5));  // it has started
  port = *gimbal.open_port();
  gimbal.set_silent(argc > 3);
  setup();
  run(sbgc::seconds(1));
  for (const char c : std::string_view(argc > 2 ? argv[2] : "")) {
    typed.push_back(static_cast<std::uint8_t>(c));
  }
  run(sbgc::seconds(std::atoi(argv[1])));
  std::printf("the camera looks %.0f degrees down\n", degrees_down());
}
