#include <algorithm>
#include <string>
#include <utility>

#include <sbgc/any.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/calibrations.hpp>
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
constexpr CalibrationConditions by_hand{.motors_off = true};

bool is_calibration(const MessageInfo* info) {
  return std::ranges::any_of(calibrations(), [&](const Calibration& one) {
    return std::ranges::find(one.forms, info, &CalibrationForm::info) != one.forms.end();
  });
}

}  // namespace

const std::vector<Calibration>& calibrations() {
  static const std::vector<Calibration> all{
      calibration<msg::CalibGyro, msg::CalibGyroExt>("gyro", false, at_rest),
      calibration<msg::CalibAcc, msg::CalibAccExt>("acc", false, at_rest),
      calibration<msg::CalibAccExtRef>("acc-reference", true, {.still = true}),
      calibration<msg::CalibMag, msg::CalibMagExt>("mag", false, by_hand),
      calibration<msg::CalibOrientCorr>("orientation"),
      calibration<msg::EncodersCalibOffset4>("encoders", false, by_hand),
      calibration<msg::EncodersCalibFldOffset4>("encoder-field"),
      calibration<msg::CalibPoles>("poles"),
      calibration<msg::CalibCogging>("cogging", true),
      calibration<msg::CalibOffset>("follow-offset"),
      calibration<msg::CalibBat>("battery", true),
      calibration<msg::CalibExtGain>("flight-controller"),
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
