#include <algorithm>
#include <string>
#include <utility>

#include <sbgc/any.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/calibrations.hpp>
#include <sbgc/internal/find_by.hpp>
#include <sbgc/meta/calibration.hpp>

namespace sbgc {

namespace {

template <class M>
concept HasAction = requires(M request) {
  request.action = msg::CalibAction::regular;
};

template <Message... Forms>
Calibration calibration(const char* name, bool needs_values = false,
                        CalibrationConditions conditions = {}) {
  return {
      name, {CalibrationForm{&Meta<Forms>::info, HasAction<Forms>}...}, needs_values, conditions};
}

constexpr CalibrationConditions at_rest{.motors_off = true, .still = true};
constexpr CalibrationConditions on_a_side{.motors_off = true, .still = true, .one_side_up = true};
constexpr CalibrationConditions by_motors{.still = true, .motors_can_turn = true};

bool is_calibration(const MessageInfo* info) {
  return std::any_of(calibrations().begin(), calibrations().end(), [&](const Calibration& one) {
    return detail::find_by(one.forms, info, &CalibrationForm::info) != one.forms.end();
  });
}

}  // namespace

const std::vector<Calibration>& calibrations() {
  static const std::vector<Calibration> all{
      calibration<msg::CalibGyro, msg::CalibGyroExt>("gyro", false, at_rest),
      calibration<msg::CalibAcc, msg::CalibAccExt>("acc", false, on_a_side),
      calibration<msg::CalibAccExtRef>("acc-reference", true, {.still = true}),
      calibration<msg::CalibMag, msg::CalibMagExt>("mag", false, {.motors_off = true}),
      calibration<msg::CalibOrientCorr>("orientation", false, by_motors),
      calibration<msg::EncodersCalibOffset4>("encoders", false,
                                             {.motors_off = true, .level = true}),
      calibration<msg::EncodersCalibFldOffset4>("encoder-field", false, by_motors),
      calibration<msg::CalibPoles>("poles", false, by_motors),
      calibration<msg::CalibCogging>("cogging", true, by_motors),
      calibration<msg::CalibOffset>("follow-offset", false, {.still = true}),
      calibration<msg::CalibBat>("battery", true, {.near_voltage = true}),
      calibration<msg::CalibExtGain>("flight-controller", false, {.level = true}),
  };
  return all;
}

namespace tasks {

Task<Result<CalibrationEnd>> run_calibration(AnyMessage request, CalibrationOptions options) {
  const MessageInfo* const info = request.type().info;
  if (!is_calibration(info)) {
    co_return ClientError{ErrorCode::invalid, std::string(info->name) + " is no calibration"};
  }
  const TaskMachine& task = co_await this_task();
  const auto prepared = detail::prepare(request, task.identity().versions(), true);
  if (!prepared) co_return prepared.error();
  const detail::StartCalibration start = [request](TaskMachine& machine) {
    CallOptions call;
    call.expect_confirmation = true;
    return machine.begin(request, call);
  };
  co_return co_await detail::run_calibration(start, prepared->policy.is_certain(),
                                             std::move(options));
}

}  // namespace tasks
}  // namespace sbgc
