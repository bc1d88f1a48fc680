#include <cstdio>

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
