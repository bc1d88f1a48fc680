// Prints fifty samples of the gimbal's yaw angle from an Asio program, unless it is interrupted:
//
//     async_stream /dev/ttyUSB0

#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>

#include <sbgc/client/async_client.hpp>
#include <sbgc/messages/realtime.hpp>

namespace {

/// Connects, then streams. All functions run on the single thread of the context.
class Printer {
 public:
  explicit Printer(asio::io_context& context)
      : client_(context.get_executor()), signals_(context, SIGINT, SIGTERM) {
    signals_.async_wait([this](std::error_code error, int) {
      if (!error) stop();
    });
  }

  void run(const std::string& address) {
    client_.async_connect(address, {}, [this](const sbgc::Result<void>& connected) {
      if (!connected) return fail(connected.error());
      std::printf("firmware %s\n", client_.identity().firmware_version().c_str());
      start_stream();
    });
  }

  int status() const { return status_; }

 private:
  void start_stream() {
    using namespace std::chrono_literals;
    client_.async_stream<sbgc::msg::RealtimeData4>(
        20ms, [this](const sbgc::msg::RealtimeData4& data) { print(data); }, {},
        [this](sbgc::Result<sbgc::Subscription> stream) {
          if (!stream) return fail(stream.error());
          stream_ = *std::move(stream);
        });
  }

  void print(const sbgc::msg::RealtimeData4& data) {
    std::printf("%2d: yaw %6.1f degrees\n", ++samples_, data.angle.yaw.degrees());
    if (samples_ == 50) stop();
  }

  void fail(const sbgc::ClientError& error) {
    std::fprintf(stderr, "%s\n", error.message.c_str());
    status_ = 1;
    stop();
  }

  void stop() {
    signals_.cancel();
    client_.close();
  }

  sbgc::AsyncClient client_;
  asio::signal_set signals_;
  sbgc::Subscription stream_;
  int samples_ = 0;
  int status_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: async_stream ADDRESS\n");
    return 2;
  }
  try {
    asio::io_context context;
    Printer printer(context);
    printer.run(argv[1]);
    context.run();
    return printer.status();
  } catch (const std::exception& error) {  // from Asio; sbgc does not throw
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
