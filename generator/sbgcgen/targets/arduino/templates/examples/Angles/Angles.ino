// Prints the angles of the camera ten times in a second. It moves nothing.
//
// Wires: TX of Serial1 to RX of the board, RX to TX, ground to ground. Check that the voltages match.

#include <sbgc.h>

sbgc::Parser parser;

void print_angles(const sbgc::Frame& frame) {
  if (frame.id != static_cast<std::uint8_t>(sbgc::msg::GetAngles::command)) return;
  sbgc::msg::GetAngles angles;
  if (!sbgc::decode(frame.body, angles)) return;
  Serial.print("roll ");
  Serial.print(angles.axes.roll.imu_angle.degrees());
  Serial.print("  pitch ");
  Serial.print(angles.axes.pitch.imu_angle.degrees());
  Serial.print("  yaw ");
  Serial.println(angles.axes.yaw.imu_angle.degrees());
}

void setup() {
  Serial.begin(115200);
  Serial1.begin(115200);
}

void loop() {
  static unsigned long asked = 0;
  if (millis() - asked >= 100) {
    asked = millis();
    std::uint8_t bytes[8];
    const auto frame = sbgc::encode_frame(sbgc::msg::GetAnglesRequest{}, bytes);
    Serial1.write(bytes, frame.size);
  }
  while (Serial1.available() > 0) {
    const auto byte = static_cast<std::uint8_t>(Serial1.read());
    parser.feed({&byte, 1}, [](const sbgc::Frame& frame) { print_angles(frame); });
  }
}
