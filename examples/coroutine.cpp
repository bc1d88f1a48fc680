// Tilts the camera to 30 degrees down, then level, slowly, in a coroutine of an Asio program:
// coroutine ADDRESS, such as /dev/ttyUSB0. The motors must be on.

#include <cstdio>
#include <exception>
#include <string>

#include <asio/awaitable.hpp>
#include <asio/co_spawn.hpp>
#include <asio/io_context.hpp>
#include <asio/use_awaitable.hpp>

#include <sbgc/client/async_client.hpp>
#include <sbgc/messages/realtime.hpp>

#include "careful.hpp"

namespace {

asio::awaitable<sbgc::Result<void>> nod(sbgc::AsyncClient& gimbal, std::string address) {
  using namespace sbgc::literals;
  const auto connected = co_await gimbal.async_connect(address, asio::use_awaitable);
  if (!connected) co_return connected.error();

  // A variable, because g++ 12 mishandles temporary options with a handler: see AsyncClient.
  const sbgc::MoveOptions slowly{.speed = 10_deg_per_s, .progress = careful::go_on};
  for (const sbgc::MoveTarget target :
       {sbgc::MoveTarget{.pitch = 30_deg}, sbgc::MoveTarget{.pitch = 0_deg}}) {
    const auto moved =
        co_await gimbal.async_run(sbgc::tasks::move_to(target, slowly), asio::use_awaitable);
    if (!moved) co_return moved.error();
    const auto angles =
        co_await gimbal.async_call(sbgc::msg::GetAnglesRequest{}, asio::use_awaitable);
    if (!angles) co_return angles.error();
    std::printf("pitch %.1f degrees\n", angles->axes.pitch.imu_angle.degrees());
  }
  co_return sbgc::Result<void>();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: coroutine ADDRESS\n");
    return 2;
  }
  if (!careful::may_move(false, "The camera turns to 30 deg down, then to pitch 0.")) return 1;
  careful::notice_signals();
  asio::io_context context;
  sbgc::AsyncClient gimbal(context.get_executor());
  int status = 1;
  asio::co_spawn(context, nod(gimbal, argv[1]),
                 [&](const std::exception_ptr& thrown, const sbgc::Result<void>& done) {
                   gimbal.close();                              // otherwise run() would go on
                   if (thrown) std::rethrow_exception(thrown);  // from Asio; sbgc does not throw
                   if (done) {
                     status = 0;
                   } else {
                     std::fprintf(stderr, "%s\n", done.error().message.c_str());
                   }
                 });
  context.run();
  return status;
}
