#include "command/version_text.hpp"

#include <fmt/format.h>

#include <sbgc/text.hpp>
#include <sbgc/version.hpp>

namespace sbgc::tools {

std::string version_text() {
  return fmt::format(
      "sbgc {}\n"
      "protocol: {}, revision {} ({}) and firmware up to {}\n"
      "model: {:016x}",
      SBGC_VERSION_TEXT, protocol_name, protocol_revision, protocol_date,
      to_string(msg::FirmwareVersion(newest_firmware)), model_fingerprint);
}

}  // namespace sbgc::tools
