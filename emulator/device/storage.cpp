// The EEPROM: settings as a whole, pages, files.

#include "device/handlers.hpp"
#include "device/device.hpp"

namespace sbgc::board {
namespace {

Outcome confirm_result(Turn& turn, msg::FileError error) {
  static_cast<void>(turn.confirm({.err_code = error}));
  return error == msg::FileError::no_error ? Outcome::carried_out : Outcome::refused;
}

}  // namespace

Outcome handle(Turn& turn, const msg::UseDefaults& request) {
  if (request.profile_id == msg::UseDefaults::erase_eeprom) {
    turn.machine.settings.erase();
    turn.machine.forget_calibrations();
  } else if (request.profile_id < SettingsOf<msg::ReadParams3>::copies) {
    turn.machine.settings.use_defaults(request.profile_id);
  } else {
    return turn.refuse(msg::BoardErrorCode::wrong_params, request.profile_id);
  }
  turn.machine.apply_settings(turn.now);
  return turn.confirm();
}

Outcome handle(Turn& turn, const msg::EepromReadRequest& request) {
  msg::EepromRead answer;
  const std::size_t size = request.size.raw();
  if (size > answer.data.capacity())
    return turn.refuse(msg::BoardErrorCode::wrong_params, request.size.raw());
  const auto bytes = turn.machine.eeprom.read_pages(request.addr, size);
  if (!bytes) return turn.refuse(msg::BoardErrorCode::wrong_params, request.addr);
  answer.addr = request.addr;
  for (const std::uint8_t byte : *bytes) answer.data.push_back(byte);
  return turn.answer(answer);
}

Outcome handle(Turn& turn, const msg::EepromWrite& request) {
  const auto data = std::span(request.data.data(), request.data.size());
  if (!turn.machine.eeprom.write_pages(request.addr, data)) {
    return turn.refuse(msg::BoardErrorCode::wrong_params, request.addr);
  }
  return turn.confirm({.addr = request.addr});
}

Outcome handle(Turn& turn, const msg::ReadFileRequest& request) {
  msg::ReadFile answer;
  const std::size_t size = request.max_data_size.raw();
  const FileSystem::Part part =
      turn.machine.files.read(request.file_id, request.page_offset.raw(), size);
  const msg::FileError error =
      size > answer.data.capacity() ? msg::FileError::wrong_params : part.error;
  if (error != msg::FileError::no_error) {
    static_cast<void>(turn.answer(msg::ReadFileError{error}));
    return Outcome::refused;
  }
  answer.file_size = msg::ByteCount(part.file_size);
  answer.page_offset = request.page_offset;
  for (const std::uint8_t byte : part.data) answer.data.push_back(byte);
  return turn.answer(answer);
}

Outcome handle(Turn& turn, const msg::WriteFile& request) {
  const msg::FileError error =
      turn.machine.files.write(request.file_id, request.file_size.raw(), request.page_offset.raw(),
                               std::span(request.data.data(), request.data.size()));
  return confirm_result(turn, error);
}

Outcome handle(Turn& turn, const msg::FsClearAll& /*request*/) {
  return confirm_result(turn, turn.machine.files.clear());
}

}  // namespace sbgc::board
