// The tasks of a client without its threads and I/O, from an installed sbgc. Compiled without
// exceptions.

#include <cstdio>

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
