// Reads the parameters of a profile, changes one and writes them, with a session.

#include <sbgc/messages/parameters.hpp>
#include <sbgc/responses/parameters.hpp>

#include "device.hpp"
#include "session.hpp"

SmallSession<sbgc::msg::WriteParams3::max_size> session;
sbgc::msg::ReadParams3 parameters{};

void take(const sbgc::Event& event) {
  if (event.outcome == sbgc::Outcome::answered) {
    if (!sbgc::decode(event.frame.body, parameters)) return;
    parameters.rc_deadband = static_cast<std::uint8_t>(device::input());
    session.send(sbgc::msg::WriteParams3{parameters});
  } else {
    device::use(event.outcome);
  }
}

int main() {
  session.send(sbgc::msg::ReadParams3Request{});
  while (true) {
    session.feed(device::received(), device::now(), take);
    device::send(session.poll(device::now(), take).bytes);
  }
}
