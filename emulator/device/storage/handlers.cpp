// spec/storage.yaml: EEPROM pages and files. parameters/access.hpp handles CMD_READ_EXTERNAL_DATA
// and CMD_WRITE_EXTERNAL_DATA.

#include "device/handlers.hpp"

#include "device/storage/eeprom.hpp"
#include "device/storage/file_system.hpp"

namespace sbgc::emulator {
namespace {

Reaction confirm_result(RequestContext& context, msg::FileError error) {
  static_cast<void>(context.confirm({.err_code = error}));
  return error == msg::FileError::no_error ? Reaction::executed : Reaction::refused;
}

}  // namespace

Reaction handle(RequestContext& context, const msg::EepromReadRequest& request,
                const Eeprom& eeprom) {
  msg::EepromRead answer;
  const std::size_t size = request.size.raw();
  if (size > answer.data.capacity())
    return context.refuse(msg::BoardErrorCode::wrong_params, request.size.raw());
  const auto bytes = eeprom.read_pages(request.addr, size);
  if (!bytes) return context.refuse(msg::BoardErrorCode::wrong_params, request.addr);
  answer.addr = request.addr;
  for (const std::uint8_t byte : *bytes) answer.data.push_back(byte);
  return context.answer(answer);
}

Reaction handle(RequestContext& context, const msg::EepromWrite& request, Eeprom& eeprom) {
  const auto data = std::span(request.data.data(), request.data.size());
  if (!eeprom.write_pages(request.addr, data)) {
    return context.refuse(msg::BoardErrorCode::wrong_params, request.addr);
  }
  return context.confirm({.addr = request.addr});
}

Reaction handle(RequestContext& context, const msg::ReadFileRequest& request,
                const FileSystem& files) {
  msg::ReadFile answer;
  const std::size_t size = request.max_data_size.raw();
  const FileSystem::Part part = files.read(request.file_id, request.page_offset.raw(), size);
  const msg::FileError error =
      size > answer.data.capacity() ? msg::FileError::wrong_params : part.error;
  if (error != msg::FileError::no_error) {
    static_cast<void>(context.answer(msg::ReadFileError{error}));
    return Reaction::refused;
  }
  answer.file_size = msg::ByteCount(part.file_size);
  answer.page_offset = request.page_offset;
  for (const std::uint8_t byte : part.data) answer.data.push_back(byte);
  return context.answer(answer);
}

Reaction handle(RequestContext& context, const msg::WriteFile& request, FileSystem& files) {
  const msg::FileError error =
      files.write(request.file_id, request.file_size.raw(), request.page_offset.raw(),
                  std::span(request.data.data(), request.data.size()));
  return confirm_result(context, error);
}

Reaction handle(RequestContext& context, const msg::FsClearAll&, FileSystem& files) {
  return confirm_result(context, files.clear());
}

}  // namespace sbgc::emulator
