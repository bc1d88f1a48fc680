// Programs of a user, one for each component: USES_… says which. Those of any and tasks are
// compiled without exceptions.

#if defined(USES_ANALYSIS)
// The power of a signal.

#include <vector>

#include <sbgc/analysis/spectrum.hpp>

int main() {
  std::vector<double> samples(64);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = i % 2 == 0 ? 1.0 : -1.0;
  const auto spectrum = sbgc::analysis::power_spectrum(samples, 64, 64);
  return spectrum.segments == 1 && spectrum.density.back() > 0.1 ? 0 : 1;
}

#elif defined(USES_ANY)
// A message whose type is known at run time.

#include <cstdio>

#include <sbgc/any.hpp>

int main() {
  const sbgc::MessageType* const type = sbgc::find_message("GetAngles");
  if (type == nullptr) return 1;
  const sbgc::AnyMessage message = type->make();
  std::printf("%s\n", message.to_json().c_str());
  return to_string(message).empty() ? 1 : 0;
}

#elif defined(USES_CLIENT)
// A client without a board.

#include <sbgc/client/async_client.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/messages/control.hpp>

int main() {
  auto client = sbgc::Client::connect("/dev/no-such-port");
  if (!client) {
    std::puts(client.error().message.c_str());
    return client.error().code == sbgc::ErrorCode::not_found ? 0 : 1;
  }
  return client->get_angles() ? 1 : 2;
}

#elif defined(USES_DOCTOR)
// Diagnoses of a gimbal that reports an error.

#include <sbgc/doctor/findings.hpp>

int main() {
  sbgc::doctor::Measurements measured;
  measured.errors = sbgc::msg::SystemError::no_sensor;
  const auto findings = sbgc::doctor::findings_of(measured);
  for (const auto& one : findings) std::puts(one.sentence.c_str());
  return findings.size() == 1 ? 0 : 1;
}

#elif defined(USES_EMULATOR)
// The emulated board.

#include <sbgc/emulator/board.hpp>

int main() {
  sbgc::emulator::Board board(sbgc::emulator::BoardOptions{}, sbgc::emulator::Memory{},
                              sbgc::Instant{});
  board.advance(sbgc::Instant{} + sbgc::seconds(1));
  const bool works = board.open_port().has_value() && board.gimbal().motors_on();
  std::printf("%s\n", works ? "the motors are on" : "the board does not work");
  return works ? 0 : 1;
}

#elif defined(USES_IO)
// A port that a program opens, and those of the machine.

#include <asio/io_context.hpp>

#include <sbgc/io/open.hpp>
#include <sbgc/io/ports.hpp>

int main() {
  asio::io_context context;
  const sbgc::io::OpenResult board = sbgc::io::open(context.get_executor(), "pty:");
  if (!board) std::puts(board.error.message.c_str());
  return board && !sbgc::io::list_ports().error ? 0 : 1;
}

#elif defined(USES_JSON)
// A message as JSON.

#include <sbgc/json_dom.hpp>
#include <sbgc/messages/peripherals.hpp>
#include <sbgc/meta/peripherals.hpp>

int main() {
  const auto json = sbgc::to_dom(sbgc::msg::BeepSound{});
  std::puts(json.dump().c_str());
  return json.empty() ? 1 : 0;
}

#elif defined(USES_TASKS)
// The tasks of a client without its threads and I/O.

#include <sbgc/client/motion.hpp>
#include <sbgc/client/passive_client.hpp>

int main() {
  sbgc::PassiveClient client;
  bool has_ended = false;
  client.start(sbgc::tasks::stop(), [&](const sbgc::Result<void>& stopped) {
    has_ended = true;
    std::printf("%s\n", stopped ? "stopped" : stopped.error().message.c_str());
  });
  sbgc::Instant now{};
  bool has_sent = false;
  while (!has_ended) {
    has_sent = !client.advance(now).empty() || has_sent;
    client.written(now);
    now = later(client.deadline(), now + sbgc::milliseconds(1));
  }
  return has_sent ? 0 : 1;  // no board answers
}

#endif
