/// A move that ends by itself when its owner no longer sends commands.
#pragma once

#include <sbgc/client/motion.hpp>

namespace sbgc::web {

/// As tasks::move_to(), but turns at speeds that last for half a second, so that the camera brakes
/// if the page is gone. The last degree is a move to the target.
/// Errors: those of move_to(), and `invalid` without a speed.
Task<Result<MoveProgress>> bounded_move(MoveTarget target, MoveOptions options);

}  // namespace sbgc::web
