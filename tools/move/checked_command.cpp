#include "move/checked_command.hpp"

namespace sbgc::tools {

std::vector<std::string> checked_command(msg::MenuCommand action) {
  switch (action) {
    case msg::MenuCommand::calib_acc: return {"calibrate", "acc"};
    case msg::MenuCommand::calib_acc_temp: return {"calibrate", "acc", "--temperature"};
    case msg::MenuCommand::calib_gyro: return {"calibrate", "gyro"};
    case msg::MenuCommand::calib_gyro_temp: return {"calibrate", "gyro", "--temperature"};
    case msg::MenuCommand::calib_mag: return {"calibrate", "mag"};
    case msg::MenuCommand::motor_on: return {"motors", "on"};
    case msg::MenuCommand::motor_off: return {"motors", "off"};
    case msg::MenuCommand::motor_toggle: return {"motors", "toggle"};
    case msg::MenuCommand::auto_pid: return {"tune"};
    case msg::MenuCommand::reset: return {"reset"};
    default: return {};
  }
}

}  // namespace sbgc::tools
