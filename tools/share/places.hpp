/// The options for places where programs connect.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <asio/any_io_executor.hpp>

#include "hosts/endpoint.hpp"

namespace sbgc::tools {

/// The heading of these options in the help.
inline constexpr const char* places_group = "Where programs connect";

struct Places {
  std::vector<hosts::ListenAddress> tcp{};
  std::vector<hosts::ListenAddress> udp{};
  bool terminal = false;
  std::vector<std::string> links{};  ///< each of a pseudo-terminal

  bool empty() const { return tcp.empty() && udp.empty() && !terminal && links.empty(); }
};

/// Adds --tcp, --udp, --pty and --link.
void add_places(CLI::App& command, Places& places);

/// Adds a repeatable option for addresses to listen on.
void add_listen(CLI::App& command, const std::string& name,
                std::vector<hosts::ListenAddress>& addresses, const std::string& help);

/// Opens the places, TCP and UDP each for this many hosts, and writes "NAME: ADDRESS" for each to
/// background_stdout(). Throws std::runtime_error.
std::vector<std::unique_ptr<hosts::Endpoint>> open_places(const asio::any_io_executor& executor,
                                                          hosts::HostPorts& ports,
                                                          const Places& places, std::size_t hosts,
                                                          const std::string& name,
                                                          const hosts::EndpointLogs& logs);

}  // namespace sbgc::tools
