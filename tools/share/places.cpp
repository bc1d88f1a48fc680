#include "share/places.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "command/background_output.hpp"
#include "command/wording.hpp"
#include "serving/arguments.hpp"

namespace sbgc::tools {

void add_listen(CLI::App& command, const std::string& name,
                std::vector<hosts::ListenAddress>& addresses, const std::string& help) {
  command
      .add_option_function<std::vector<std::string>>(
          name,
          [&addresses](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) addresses.push_back(serving::parse_listen(text));
          },
          help)
      ->check([](const std::string& text) -> std::string {
        try {
          static_cast<void>(serving::parse_listen(text));
          return {};
        } catch (const std::invalid_argument& error) {
          return error.what();
        }
      })
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("[HOST:]PORT")
      ->group(places_group);
}

void add_places(CLI::App& command, Places& places) {
  add_listen(command, "--tcp", places.tcp,
             "Listen on this TCP port, 0 for any free one; on localhost unless HOST is another "
             "address of this machine");
  add_listen(command, "--udp", places.udp, "Listen on this UDP port; each sender is a program");
  command.add_flag("--pty", places.terminal, "A pseudo-terminal")->group(places_group);
  command.add_option("--link", places.links, "A pseudo-terminal with this symbolic link to it")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("PATH")
      ->group(places_group);
}

std::vector<std::unique_ptr<hosts::Endpoint>> open_places(const asio::any_io_executor& executor,
                                                          hosts::HostPorts& ports,
                                                          const Places& places, std::size_t hosts,
                                                          const std::string& name,
                                                          const hosts::EndpointLogs& logs) {
  std::vector<std::unique_ptr<hosts::Endpoint>> opened;
  const auto add = [&](std::unique_ptr<hosts::Endpoint> endpoint) {
    background_stdout().write(printable(fmt::format("{}: {}\n", name, endpoint->address())));
    opened.push_back(std::move(endpoint));
  };
  for (const auto& at : places.tcp) {
    add(hosts::listen_tcp(executor, ports, at, hosts, logs));
  }
  for (const auto& at : places.udp) {
    add(hosts::listen_udp(executor, ports, at, hosts, logs));
  }
  if (places.terminal) add(hosts::open_terminal(executor, ports, "", false, logs));
  for (const std::string& link : places.links) {
    add(hosts::open_terminal(executor, ports, link, false, logs));
  }
  return opened;
}

}  // namespace sbgc::tools
