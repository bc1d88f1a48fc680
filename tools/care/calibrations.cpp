#include "care/calibrations.hpp"

#include <sbgc/meta/calibration.hpp>
#include <sbgc/surplus.hpp>

namespace sbgc::tools {

namespace {

template <class M>
concept HasAction = requires(M request) {
  request.action = msg::CalibAction::regular;
};

template <Message M>
Result<CalibrationEnd> run(Client& client, const AnyMessage& request,
                           const CalibrationOptions& options) {
  return client.run_calibration(without_surplus(*request.get_if<M>()), options);
}

template <Message... Forms>
Calibration calibration(const char* name, bool needs_values = false) {
  return {
      name, {CalibrationForm{&Meta<Forms>::info, run<Forms>, HasAction<Forms>}...}, needs_values};
}

}  // namespace

const std::vector<Calibration>& calibrations() {
  static const std::vector<Calibration> all{
      calibration<msg::CalibGyro, msg::CalibGyroExt>("gyro"),
      calibration<msg::CalibAcc, msg::CalibAccExt>("acc"),
      calibration<msg::CalibAccExtRef>("acc-reference", true),
      calibration<msg::CalibMag, msg::CalibMagExt>("mag"),
      calibration<msg::CalibOrientCorr>("orientation"),
      calibration<msg::EncodersCalibOffset4>("encoders"),
      calibration<msg::EncodersCalibFldOffset4>("encoder-field"),
      calibration<msg::CalibPoles>("poles"),
      calibration<msg::CalibCogging>("cogging", true),
      calibration<msg::CalibOffset>("follow-offset"),
      calibration<msg::CalibBat>("battery", true),
      calibration<msg::CalibExtGain>("flight-controller"),
  };
  return all;
}

}  // namespace sbgc::tools
