/// WebSockets as a place where programs connect.
#pragma once

#include <memory>

#include "serving/endpoint.hpp"
#include "share/web_socket_access.hpp"

namespace sbgc::tools {

/// Listens for WebSockets. Binary messages are bytes of the protocol, however they are cut. Throws
/// std::runtime_error.
std::unique_ptr<serving::Endpoint> listen_web_socket(const asio::any_io_executor& executor,
                                                     serving::HostPorts& ports,
                                                     const serving::ListenAddress& address,
                                                     const WebSocketAccess& access,
                                                     const serving::EndpointLogs& logs);

}  // namespace sbgc::tools
