/// WebSockets as a place where programs connect.
#pragma once

#include <memory>

#include "hosts/endpoint.hpp"
#include "share/web_access.hpp"

namespace sbgc::tools {

/// Listens for WebSockets. Binary messages are bytes of the protocol, however they are cut. Throws
/// std::runtime_error.
std::unique_ptr<hosts::Endpoint> listen_web_socket(const asio::any_io_executor& executor,
                                                   hosts::HostPorts& ports,
                                                   const hosts::ListenAddress& address,
                                                   const WebSocketAccess& access,
                                                   const hosts::EndpointLogs& logs);

}  // namespace sbgc::tools
