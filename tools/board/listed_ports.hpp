/// The serial ports of this machine, or those of a list that replaces them.
#pragma once

#include <vector>

#include <sbgc/io/ports.hpp>
#include <sbgc/json_dom.hpp>

namespace sbgc::tools {

/// Returns the serial ports. If the environment variable SBGC_PORTS is set, reads them from the
/// file that it names, in the format of `sbgc ports --format json`: for ports that the system does
/// not list, and for tests.
io::PortList listed_ports();

/// Returns the output of `sbgc ports --format json`.
Json ports_json(const std::vector<io::PortInfo>& ports);

}  // namespace sbgc::tools
