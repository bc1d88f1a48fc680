#include "device/modules/module_flash.hpp"

#include <utility>

#include <sbgc/internal/crc32.hpp>

namespace sbgc::emulator {

bool ModuleFlash::start(const msg::ModuleFlashStart& request) {
  // Assumption: no module takes more.
  constexpr std::uint32_t most_words = 1U << 20U;
  const std::uint32_t words = request.firmware_size.raw();
  if (words == 0 || words > most_words) return false;
  run_ = Run{request.device_id, std::size_t{words} * 4, 0, {}};
  firmware_[request.device_id].clear();
  return true;
}

bool ModuleFlash::write(const msg::ModuleFlashWrite& request) {
  if (!run_ || run_->module != request.device_id) return false;
  const std::span<const std::uint8_t> data(request.data.data(), request.data.size());
  const bool is_next = request.packet_id == run_->packet && request.address == run_->data.size();
  if (!is_next || run_->data.size() + data.size() > run_->size) return false;
  if (sbgc::detail::crc32(data) != request.data_crc32) return false;
  run_->data.insert(run_->data.end(), data.begin(), data.end());
  ++run_->packet;
  return true;
}

bool ModuleFlash::finish(const msg::ModuleFlashFinish& request) {
  if (!run_ || run_->module != request.device_id || run_->data.size() != run_->size) return false;
  if (sbgc::detail::crc32(run_->data) != request.file_crc32) return false;
  firmware_[run_->module] = std::move(run_->data);
  run_.reset();
  return true;
}

}  // namespace sbgc::emulator
