// The EEPROM: settings as a whole, pages, files.

#include "handlers.hpp"
#include "machine.hpp"

namespace sbgc::board {
namespace {

Outcome confirm_result(Turn& turn, FileError error) {
  static_cast<void>(turn.confirm({.err_code = error}));
  return error == FileError::no_error ? Outcome::carried_out : Outcome::refused;
}

}  // namespace

Outcome handle(Turn& turn, const UseDefaults& request) {
  if (request.profile_id == UseDefaults::erase_eeprom) {
    turn.machine.settings.erase();
    turn.machine.forget_calibrations();
  } else if (request.profile_id < SettingsOf<ReadParams3>::copies) {
    turn.machine.settings.use_defaults(request.profile_id);
  } else {
    return turn.refuse(BoardErrorCode::wrong_params, request.profile_id);
  }
  turn.machine.apply_settings(turn.now);
  return turn.confirm();
}

Outcome handle(Turn& turn, const EepromReadRequest& request) {
  EepromRead answer;
  const std::size_t size = request.size.raw();
  if (size > answer.data.capacity())
    return turn.refuse(BoardErrorCode::wrong_params, request.size.raw());
  const auto bytes = turn.machine.eeprom.read_pages(request.addr, size);
  if (!bytes) return turn.refuse(BoardErrorCode::wrong_params, request.addr);
  answer.addr = request.addr;
  for (const std::uint8_t byte : *bytes) answer.data.push_back(byte);
  return turn.answer(answer);
}

Outcome handle(Turn& turn, const EepromWrite& request) {
  const auto data = std::span(request.data.data(), request.data.size());
  if (!turn.machine.eeprom.write_pages(request.addr, data)) {
    return turn.refuse(BoardErrorCode::wrong_params, request.addr);
  }
  return turn.confirm({.addr = request.addr});
}

Outcome handle(Turn& turn, const ReadFileRequest& request) {
  ReadFile answer;
  const std::size_t size = request.max_data_size.raw();
  const FileSystem::Part part =
      turn.machine.files.read(request.file_id, request.page_offset.raw(), size);
  const FileError error = size > answer.data.capacity() ? FileError::wrong_params : part.error;
  if (error != FileError::no_error) {
    static_cast<void>(turn.answer(ReadFileError{error}));
    return Outcome::refused;
  }
  answer.file_size = ByteCount(part.file_size);
  answer.page_offset = request.page_offset;
  for (const std::uint8_t byte : part.data) answer.data.push_back(byte);
  return turn.answer(answer);
}

Outcome handle(Turn& turn, const WriteFile& request) {
  const FileError error =
      turn.machine.files.write(request.file_id, request.file_size.raw(), request.page_offset.raw(),
                               std::span(request.data.data(), request.data.size()));
  return confirm_result(turn, error);
}

Outcome handle(Turn& turn, const FsClearAll& /*request*/) {
  return confirm_result(turn, turn.machine.files.clear());
}

}  // namespace sbgc::board
