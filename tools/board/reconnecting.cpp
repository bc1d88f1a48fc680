#include "board/reconnecting.hpp"

#include <utility>

#include <fmt/format.h>

#include "board/listed_ports.hpp"
#include "command/remark.hpp"

namespace sbgc::tools {

bool is_replay(const GimbalOptions& options) {
  return with_configuration(options).port.starts_with("capture:");
}

Client connect_for_long(const GimbalOptions& options,
                        const std::function<void(ConnectOptions&)>& adjust) {
  LineChoice line = choose_line(options);
  if (adjust) adjust(line.options);
  ReconnectOptions reconnect;
  reconnect.connection = line.options;
  reconnect.list_ports = listed_ports;
  auto client = Client::connect(line.address, reconnect);
  // A recorded board responds when it did, perhaps just before the request.
  for (int more = 4; !client && more > 0 && is_replay(options); --more) {
    client = Client::connect(line.address, reconnect);
  }
  return value_of(std::move(client));
}

Subscription report_changes(Client& client) {
  return client.on_change([](const LinkChange& change) {
    switch (change.state) {
      case LinkState::lost:
      case LinkState::other_board:
      case LinkState::given_up: return remark_failure(change.message);
      case LinkState::searching: return remark("sbgc: connecting again ...\n");
      case LinkState::connected: return remark("sbgc: connected again: {}\n", change.message);
      case LinkState::closed: return;
    }
  });
}

}  // namespace sbgc::tools
