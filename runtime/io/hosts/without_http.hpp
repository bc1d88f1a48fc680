/// Protects a TCP port from web pages.
#pragma once

#include <memory>
#include <system_error>

#include <sbgc/io/transport.hpp>

namespace sbgc::hosts {

/// Returns a transport whose read fails with is_http_request() if its first bytes are those of an
/// HTTP or HTTPS request. Any web page can make a browser send one to this machine, with frames in
/// its body. No byte is passed on before this is decided; no frame begins like such a request.
std::unique_ptr<io::Transport> without_http(std::unique_ptr<io::Transport> transport);

bool is_http_request(std::error_code error);

}  // namespace sbgc::hosts
