/// WebSocket endpoints for programs.
#pragma once

#include <memory>

#include "hosts/endpoint.hpp"
#include "share/web_access.hpp"

namespace sbgc::tools {

/// Listens for WebSockets. Binary messages are bytes of the protocol, split arbitrarily. Throws
/// std::runtime_error.
std::unique_ptr<hosts::Endpoint> listen_web_socket(const asio::any_io_executor& executor,
                                                   hosts::HostPorts& ports,
                                                   const hosts::ListenAddress& address,
                                                   const WebSocketAccess& access,
                                                   const hosts::EndpointLogs& logs);

}  // namespace sbgc::tools
