// The emulated board from an installed sbgc.

#include <cstdio>

#include <sbgc/emulator/board.hpp>

int main() {
  sbgc::emulator::Board board(sbgc::emulator::BoardOptions{}, sbgc::emulator::Memory{},
                              sbgc::Instant{});
  board.advance(sbgc::Instant{} + sbgc::seconds(1));
  const bool works = board.open_port().has_value() && board.gimbal().motors_on();
  std::printf("%s\n", works ? "the motors are on" : "the board does not work");
  return works ? 0 : 1;
}
