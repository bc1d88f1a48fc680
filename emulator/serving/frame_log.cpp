#include "serving/frame_log.hpp"

namespace sbgc::serving {

void FrameLog::add(const emulator::Board::Traffic& traffic) {
  if (traffic.at != at_ || traffic.port != port_) responses_ = 0;
  at_ = traffic.at;
  port_ = traffic.port;
  const bool is_request = traffic.reaction.has_value();
  const auto place = lines_.end() - static_cast<std::ptrdiff_t>(is_request ? responses_ : 0);
  lines_.insert(place, describe_(traffic));
  responses_ = is_request ? 0 : responses_ + 1;
}

std::vector<std::string> FrameLog::take() {
  responses_ = 0;
  return std::exchange(lines_, {});
}

}  // namespace sbgc::serving
