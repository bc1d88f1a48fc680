// Tests of outputs and variables of later firmware.

#include <cstdint>
#include <set>

#include <sbgc/meta/variables.hpp>

#include "device/device.hpp"
#include "host.hpp"

namespace sbgc::test {
namespace {

TEST(Servos, OnlyTheSelectedOnesChange) {
  emulator::Device device(newest_board(), {}, {});
  msg::ServoOut first;
  first.servo_time = {msg::ServoPulse(1000), msg::ServoPulse(1100), msg::ServoPulse(-1),
                      msg::ServoPulse(-1),   msg::ServoPulse(-1),   msg::ServoPulse(-1),
                      msg::ServoPulse(-1),   msg::ServoPulse(-1)};
  ASSERT_TRUE(device.outputs.set_servos(device.parameters, first));
  msg::ServoOutExt request;
  request.servo_bits = msg::ServoOutput::servo2 | msg::ServoOutput::can_drv7_servo2;
  request.servo_time.push_back(msg::ServoPulse(1500));
  request.servo_time.push_back(msg::ServoPulse(1600));
  EXPECT_TRUE(device.outputs.set_servos(device.parameters, request));
  EXPECT_EQ(device.outputs.servo(0), msg::ServoPulse(1000));
  EXPECT_EQ(device.outputs.servo(1), msg::ServoPulse(1500));
  EXPECT_EQ(device.outputs.driver_servo(13), msg::ServoPulse(1600));
  request.servo_time[0] = msg::ServoPulse(20'000);
  EXPECT_FALSE(device.outputs.set_servos(device.parameters, request)) << "longer than the period";
  EXPECT_EQ(device.outputs.servo(1), msg::ServoPulse(1500));
}

TEST(VariablePages, ListEveryVariableOnce) {
  Host host(newest_board());
  const auto total = host.get<msg::BoardInfo3>(msg::BoardInfo3Request{}).adj_vars_total_num;
  EXPECT_EQ(total, std::size(variables));
  std::set<msg::VariableId> found;
  msg::AdjVarsInfoRequest request;
  for (int page = 0; page < 20 && found.size() < total; ++page) {
    const auto info = host.get<msg::AdjVarsInfo>(request);
    ASSERT_EQ(info.total_number, total);
    ASSERT_FALSE(info.vars.empty());
    for (const msg::AdjVarInfo& one : info.vars) {
      EXPECT_TRUE(found.insert(one.var_id).second);
      EXPECT_LE(one.name.size(), 16U);
      EXPECT_LE(one.range_min, one.range_max);
    }
    request.start_id = static_cast<msg::VariableId>(static_cast<unsigned>(*found.rbegin()) + 1);
  }
  EXPECT_EQ(found.size(), total);
}

}  // namespace
}  // namespace sbgc::test
