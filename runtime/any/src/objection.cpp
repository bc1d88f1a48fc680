#include <sbgc/any.hpp>
#include <sbgc/text.hpp>

namespace sbgc {

std::string objection_to(const MessageInfo& info, const Availability& versions) {
  const auto firmware = [](std::uint16_t version) {
    return to_string(msg::FirmwareVersion(version));
  };
  if (info.until.firmware != 0 && info.until.firmware <= versions.firmware) {
    return "needs firmware before " + firmware(info.until.firmware);
  }
  if (info.since.firmware > versions.firmware) {
    return "needs firmware " + firmware(info.since.firmware);
  }
  if (info.since.board > versions.board) {
    return "needs board " + to_string(msg::BoardVersion(info.since.board));
  }
  return "";
}

}  // namespace sbgc
