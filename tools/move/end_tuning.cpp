#include "move/end_tuning.hpp"

#include <chrono>
#include <thread>

#include <sbgc/availability.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/messages/realtime.hpp>

namespace sbgc::tools {

Result<bool> is_tuning(Client& client) {
  if (!is_supported<msg::RealtimeData4Request>(client.identity().versions())) return false;
  const Result<msg::RealtimeData4> data = client.call(msg::RealtimeData4Request{});
  if (!data) return data.error();
  return data->calib_mode == msg::CalibMode::auto_pid;
}

Result<void> end_tuning(Client& client) {
  if (!is_supported<msg::AutoPidRequest>(client.identity().versions())) return {};
  msg::AutoPidRequest request;
  request.cfg_flags = msg::AutoPidFlags(msg::AutoPidRequest::stop_tuning);
  constexpr int attempts = 5;
  ClientError problem{ErrorCode::timeout, "the board goes on tuning"};
  for (int i = 0; i < attempts; ++i) {
    const Result<void> sent(client.call(request));  // which few boards confirm
    if (!sent && sent.error().code != ErrorCode::board_error) {
      problem = sent.error();
      continue;
    }
    const Result<bool> tunes = is_tuning(client);
    if (tunes && !*tunes) return {};
    if (!tunes) problem = tunes.error();
    constexpr std::chrono::milliseconds until_it_shows{100};
    std::this_thread::sleep_for(until_it_shows);
  }
  return problem;
}

}  // namespace sbgc::tools
