#include "calls/stream_listeners.hpp"

#include <algorithm>

namespace sbgc::detail {

const Request& StreamListeners::Stream::fastest() const {
  const auto faster = [](const auto& a, const auto& b) {
    return a.second.interval_us() < b.second.interval_us();
  };
  return std::min_element(shares.begin(), shares.end(), faster)->second.start;
}

StreamListeners::Listener StreamListeners::join(const Key& key, const Request& start, Request end) {
  Stream& stream = streams_[key];
  stream.shares[++last_] = {start};
  stream.end = std::move(end);
  return last_;
}

Request StreamListeners::fastest(const Key& key) const { return streams_.at(key).fastest(); }

bool StreamListeners::is_due(const Key& key, Listener listener) {
  const auto stream = streams_.find(key);
  if (stream == streams_.end()) return false;
  const auto found = stream->second.shares.find(listener);
  if (found == stream->second.shares.end()) return false;
  Share& share = found->second;
  const std::int64_t wanted = share.interval_us();
  // Before the board has confirmed an interval, it sends at that of the only listener.
  share.credit_us += stream->second.is_running ? stream->second.interval_us : wanted;
  if (share.credit_us < wanted) return false;
  share.credit_us = std::min(share.credit_us - wanted, wanted);
  return true;
}

std::optional<Request> StreamListeners::set_running(const Key& key, std::uint32_t interval_us) {
  const auto place = streams_.find(key);
  if (place == streams_.end()) return std::nullopt;
  Stream& stream = place->second;
  stream.is_running = true;
  stream.interval_us = interval_us;
  if (stream.shares.empty()) return std::nullopt;
  const Request& wanted = stream.fastest();
  if (wanted.policy.stream.interval_us == interval_us) return std::nullopt;
  return wanted;
}

std::optional<Request> StreamListeners::leave(const Key& key, Listener listener) {
  const auto place = streams_.find(key);
  if (place == streams_.end()) return std::nullopt;
  Stream& stream = place->second;
  stream.shares.erase(listener);
  if (stream.shares.empty()) {
    if (stream.is_running) return stream.end;
    streams_.erase(place);
    return std::nullopt;
  }
  const Request& wanted = stream.fastest();
  if (!stream.is_running || wanted.policy.stream.interval_us == stream.interval_us) {
    return std::nullopt;
  }
  return wanted;
}

void StreamListeners::end_sent(const Key& key) {
  const auto place = streams_.find(key);
  if (place != streams_.end() && place->second.shares.empty()) streams_.erase(place);
}

std::vector<Request> StreamListeners::take_running() {
  std::vector<Request> ends;
  for (auto& [key, stream] : streams_) {
    if (stream.is_running) ends.push_back(std::move(stream.end));
  }
  streams_.clear();
  return ends;
}

}  // namespace sbgc::detail
