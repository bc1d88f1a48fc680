#include "driving/asio_driver.hpp"

#include <utility>

#include <asio/post.hpp>

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
  const TaskStep step = advance([this] { return timer_.now(); });
  if (step.kind == TaskStep::Kind::done) {
    timer_.cancel();
    end();
    return std::exchange(done_, nullptr)();
  }
  timer_.start(step.until, [this, self = shared_from_this()] { proceed(); });
}

}  // namespace sbgc::detail
