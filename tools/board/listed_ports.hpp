/// The serial ports of this machine, or those of a list that takes their place.
#pragma once

#include <vector>

#include <sbgc/io/ports.hpp>
#include <sbgc/json_dom.hpp>

namespace sbgc::tools {

/// Returns the serial ports. If the environment variable SBGC_PORTS is set, reads them from the
/// file that it names, in the format of `sbgc ports --format json`: for ports that the system does
/// not list, and for tests.
io::PortList listed_ports();

/// Returns what `sbgc ports --format json` prints.
Json ports_json(const std::vector<io::PortInfo>& ports);

}  // namespace sbgc::tools
