/// The automatic tuning of the controllers, in which the board finds their gains. It shakes the
/// camera for some minutes and stores the gains at its end. Read docs/2-safety.md first, and keep
/// the old parameters to write them back.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <sbgc/client/task.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/types.hpp>

namespace sbgc {

/// The axes to tune, and the way to tune them.
struct TuningChoice {
  Axes<bool> axes{true, true, true};  ///< those to tune
  double gain = 50;           ///< from 0, which prefers stability, to 100, which prefers high gains
  bool from_current = false;  ///< begin with the present gains
  bool filters = false;       ///< tune the low-pass filters as well
  std::uint8_t profile{};     ///< from 0
};

/// Returns the request that starts the tuning. The board reports its progress.
msg::AutoPidRequest tuning_request(const TuningChoice& choice);

/// Options of run_tuning().
struct TuningOptions {
  /// Called several times per second with the last report of the board. Returning false ends the
  /// wait with ErrorCode::cancelled.
  std::function<bool(const std::optional<msg::AutoPid>& report)> progress{};
};

namespace tasks {

/// Starts the tuning and waits until the board ends it. After an error, the board may continue:
/// then call end_tuning() and stop(), and write the old parameters back. Not for firmware that
/// tunes with CMD_AUTO_PID2, which is poorly documented.
/// Errors: those of Client::call(); `timeout` if the board reports no progress; `cancelled` by
/// TuningOptions::progress.
Task<Result<void>> run_tuning(msg::AutoPidRequest request, TuningOptions options = {});

/// True if the live data show that the board is tuning. Early firmware does not report it, and has
/// no such data. Errors: those of Client::call().
Task<Result<bool>> is_tuning();

/// Ends the tuning, and verifies that it has ended. Parameters that the board has already stored
/// remain. Errors: those of Client::call(); `timeout` if the board continues.
Task<Result<void>> end_tuning();

}  // namespace tasks
}  // namespace sbgc
