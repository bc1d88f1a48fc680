#include "link.hpp"

#include <stdexcept>
#include <utility>

#include <sys/eventfd.h>
#include <unistd.h>

namespace sbgc::python {

Bell::Bell() : descriptor_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (descriptor_ < 0) throw std::runtime_error("no file descriptor is left");
}
Bell::~Bell() { ::close(descriptor_); }
void Bell::ring() const noexcept {
  const eventfd_t one = 1;
  static_cast<void>(eventfd_write(descriptor_, one));
}
void Bell::silence() const noexcept {
  eventfd_t count = 0;
  static_cast<void>(eventfd_read(descriptor_, &count));
}

void raise_client(const ClientError& error) {
  const bool is_lost = error.code == ErrorCode::link_lost || error.code == ErrorCode::not_connected;
  raise(error.code == ErrorCode::timeout ? "GimbalTimeout"
        : is_lost                        ? "GimbalDisconnected"
                                         : "GimbalError",
        error.message, name(error.code), error.detail);
}

Link::Link() : process_(getpid()), state_(std::make_unique<State>()) {
  state_->thread = std::thread([&context = state_->context] { context.run(); });
}

Link::~Link() {
  if (process_ != getpid()) {
    static_cast<void>(state_.release());
    return;
  }
  close();
  if (state_->connecting.joinable()) state_->connecting.join();
  state_->work.reset();  // what still runs ends soon, because the line is closed
  state_->thread.join();
}

std::shared_ptr<Operation> Link::connect(detail::Opener opener, const ConnectOptions& options) {
  auto operation = std::make_shared<Operation>(state_->bell);
  State& state = *state_;
  operation->set_cancel([&state] {
    const std::scoped_lock lock(state.mutex);
    state.conversation.close();
  });
  state.connecting = std::thread([&state, operation, opener = std::move(opener), options] {
    auto found = detail::connect(state.executor(), opener, options,
                                 [&state](const detail::Conversation& begun) {
                                   const std::scoped_lock lock(state.mutex);
                                   state.conversation = begun;
                                 });
    if (found) {
      const std::scoped_lock lock(state.mutex);
      state.is_connected = true;
    }
    const Result<void> result = found ? Result<void>() : std::move(found).error();
    operation->end([result] { return to_python(result); });
  });
  return operation;
}

const detail::Conversation& Link::conversation() const {
  if (process_ != getpid()) {
    raise_client({ErrorCode::invalid, "the client belongs to the process that forked this one"});
  }
  const std::scoped_lock lock(state_->mutex);
  if (!state_->is_connected) {
    raise_client({ErrorCode::not_connected, "the client is not connected"});
  }
  return state_->conversation;
}

std::shared_ptr<Operation> Link::begin() {
  static_cast<void>(conversation());
  return std::make_shared<Operation>(state_->bell, state_->time);
}

std::function<void()> Link::drive(const std::shared_ptr<Operation>& operation, TaskMachine& task,
                                  std::function<void()> done) {
  const auto driver = std::make_shared<detail::AsioDriver>(state_->executor(), conversation(), task,
                                                           std::move(done));
  const auto put = [weak = std::weak_ptr(driver)](detail::TaskDriver::Input input) {
    if (const auto running = weak.lock()) running->put(std::move(input));
  };
  operation->set_cancel([put] { put([](TaskMachine& one) { one.cancel(); }); });
  {
    const std::scoped_lock lock(state_->mutex);
    std::erase_if(state_->running, [](const auto& one) { return one.expired(); });
    state_->running.push_back(operation);
  }
  driver->start();
  return [put] { put([](TaskMachine& one) { one.wake(); }); };
}

void Link::close() {
  if (process_ != getpid()) return;
  // A camera stops within this time, unless the line is lost.
  constexpr Duration patience = seconds(1);
  std::vector<std::weak_ptr<Operation>> running;
  detail::Conversation conversation;
  {
    const std::scoped_lock lock(state_->mutex);
    state_->is_connected = false;
    running.swap(state_->running);
    conversation = state_->conversation;
  }
  const Instant until = now() + patience;
  for (const auto& weak : running) {
    if (const auto operation = weak.lock()) operation->cancel();
  }
  for (const auto& weak : running) {
    if (const auto operation = weak.lock()) operation->wait_until(until);
  }
  if (!conversation) return;
  conversation.close();
  // What the board hears last; otherwise, the thread sees to it.
  if (state_->time) state_->time->run([] { return false; }, now() + milliseconds(250));
}

}  // namespace sbgc::python
