// Tilts the camera 10 degrees down, slowly, when you type y in the serial monitor, and never else. The
// motors must be on.
//
// A real gimbal can injure people. Keep hands and cables clear, and a hand on its battery switch.
//
// Wires: TX of Serial1 to RX of the board, RX to TX, ground to ground. Check that the voltages match.

#include <sbgc.h>

using namespace sbgc::literals;

// Room for two requests. A session waits for responses, repeats what is safe to repeat, and keeps the
// pauses that the board needs.
sbgc::BasicSession<sbgc::SessionCapacity{.requests = 2, .late_replies = 2, .streams = 1}> session(
    {.line = {.baud_rate = 115200}});

// The time for the session. micros() starts again at 0 every 71 minutes; this does not.
sbgc::Instant now() {
  static std::uint32_t last = 0;
  static std::int64_t time = 0;
  const std::uint32_t newest = micros();
  time += static_cast<std::uint32_t>(newest - last);
  last = newest;
  return {time};
}

// Tilts the camera; roll and yaw keep their targets.
void tilt(const sbgc::msg::GetAngles& angles) {
  sbgc::msg::Control control;
  control.control_mode = sbgc::msg::ControlMode::angle;
  control.axes.roll = {.speed = 10_deg_per_s, .angle = angles.axes.roll.rc_target_angle};
  control.axes.pitch = {.speed = 10_deg_per_s, .angle = 10_deg};
  control.axes.yaw = {.speed = 10_deg_per_s, .angle = angles.axes.yaw.rc_target_angle};
  session.send(control);
}

void on_event(const sbgc::Event& event) {
  if (event.kind != sbgc::EventKind::completed) return;
  if (event.outcome == sbgc::Outcome::answered) {
    sbgc::msg::GetAngles angles;
    if (sbgc::decode(event.frame.body, angles)) tilt(angles);
  } else if (event.outcome == sbgc::Outcome::sent) {
    Serial.println("The camera tilts.");
  } else {
    Serial.println("The board does not answer.");
  }
}

void setup() {
  Serial.begin(115200);
  Serial1.begin(115200);
  Serial.println("Type y to tilt the camera 10 degrees down.");
}

void loop() {
  if (Serial.available() > 0 && Serial.read() == 'y') {
    session.send(sbgc::msg::GetAnglesRequest{});
  }
  while (Serial1.available() > 0) {
    const auto byte = static_cast<std::uint8_t>(Serial1.read());
    session.feed({&byte, 1}, now(), on_event);
  }
  const sbgc::Output output = session.poll(now(), on_event);
  if (!output.bytes.empty()) Serial1.write(output.bytes.data(), output.bytes.size());
}
