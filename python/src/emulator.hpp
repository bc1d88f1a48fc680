/// An emulated board in this process, in real time.
#pragma once

#include <memory>
#include <string>

#include <sbgc/client/own_transport.hpp>

#include "binding.hpp"

namespace sbgc::python {

class Emulation;

/// Returns the factory of lines to the board.
TransportFactory line_to(const std::shared_ptr<Emulation>& board);

}  // namespace sbgc::python
