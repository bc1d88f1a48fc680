#include "motion/end_tuning.hpp"

#include <sbgc/availability.hpp>
#include <sbgc/messages/calibration.hpp>

namespace sbgc::tools {

Result<void> end_tuning(Client& client) {
  if (!is_supported<msg::AutoPidRequest>(client.identity().versions())) return {};
  msg::AutoPidRequest request;
  request.cfg_flags = msg::AutoPidFlags(msg::AutoPidRequest::stop_tuning);
  return client.call(request);
}

}  // namespace sbgc::tools
