/// The end of the automatic tuning, during which the board shakes the camera.
#pragma once

#include <sbgc/client/client.hpp>

namespace sbgc::tools {

/// Ends the tuning. Parameters that the board has stored already stay.
Result<void> end_tuning(Client& client);

}  // namespace sbgc::tools
