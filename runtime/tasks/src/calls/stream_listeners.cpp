#include "calls/stream_listeners.hpp"

namespace sbgc::detail {

void StreamListeners::join(const Key& key, Request end) {
  Stream& stream = streams_[key];
  ++stream.listeners;
  stream.end = std::move(end);
}

void StreamListeners::set_running(const Key& key) {
  const auto place = streams_.find(key);
  if (place != streams_.end()) place->second.is_running = true;
}

std::optional<Request> StreamListeners::leave(const Key& key) {
  const auto place = streams_.find(key);
  if (place == streams_.end() || --place->second.listeners != 0) return std::nullopt;
  if (place->second.is_running) return place->second.end;
  streams_.erase(place);
  return std::nullopt;
}

void StreamListeners::end_sent(const Key& key) {
  const auto place = streams_.find(key);
  if (place != streams_.end() && place->second.listeners == 0) streams_.erase(place);
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
