// Decodes every message of the board, with a session of the usual capacity and both framings.

#include <sbgc/messages.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>
#include <sbgc/visit.hpp>

#include "device.hpp"

sbgc::Session session;

void take(const sbgc::Event& event) {
  sbgc::visit(event.frame, sbgc::Direction::from_board,
              [](const auto& message) { device::use(message); });
}

int main() {
  session.send(sbgc::msg::BoardInfoRequest{});
  while (true) {
    session.feed(device::received(), device::now(), take);
    device::send(session.poll(device::now(), take).bytes);
  }
}
