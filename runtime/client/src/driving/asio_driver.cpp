#include "driving/asio_driver.hpp"

#include <system_error>
#include <utility>

#include <asio/post.hpp>

#include <sbgc/io/clock.hpp>

namespace sbgc::detail {

AsioDriver::AsioDriver(const asio::any_io_executor& executor, Conversation conversation,
                       TaskMachine& task, std::function<void()> done)
    : TaskDriver(std::move(conversation), task),
      strand_(asio::make_strand(executor)),
      timer_(strand_),
      done_(std::move(done)) {}

void AsioDriver::start() {
  listen();
  input_arrived();
}

void AsioDriver::input_arrived() {
  asio::post(strand_, [this, self = shared_from_this()] { proceed(); });
}

void AsioDriver::proceed() {
  if (!done_) return;
  const TaskStep step = advance(Clock::system());
  if (step.kind == TaskStep::Kind::done) {
    timer_.cancel();
    end();
    return std::exchange(done_, nullptr)();
  }
  timer_.expires_at(io::to_chrono(step.until));
  timer_.async_wait([this, self = shared_from_this()](const std::error_code& error) {
    if (!error) proceed();
  });
}

}  // namespace sbgc::detail
