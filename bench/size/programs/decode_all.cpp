// Decodes a frame as one message: the mean of all messages.

#include <sbgc/dispatch.hpp>
#include <sbgc/message.hpp>

#include "device.hpp"

namespace {

template <class M>
[[gnu::noinline]] void decode_one(const sbgc::Frame& frame, M& message) {
  if constexpr (requires { sbgc::decode(frame.body, message); }) {
    if (sbgc::decode(frame.body, message)) device::use(message);
  }
}

template <class... M>
void decode_all(const sbgc::Frame& frame, sbgc::TypeList<M...>) {
  (decode_one(frame, *static_cast<M*>(device::memory)), ...);
}

}  // namespace

int main() {
  decode_all({.body = device::received()}, sbgc::AllMessages{});
  return 0;
}
