#include "link.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

#include <sys/eventfd.h>
#include <unistd.h>

#include "conversation/state.hpp"

namespace sbgc::python {

Bell::Bell() : descriptor_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (descriptor_ < 0) throw std::runtime_error("no file descriptor is left");
}
Bell::~Bell() { ::close(descriptor_); }
void Bell::ring() const noexcept {
  const eventfd_t one = 1;
  static_cast<void>(eventfd_write(descriptor_, one));
}
void Bell::drain() const noexcept {
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
  state_->blocked.clear();  // joins
  if (state_->reconnecting) state_->reconnecting->finish();
  state_->work.reset();  // what still runs ends soon, because the line is closed
  state_->thread.join();
}

std::shared_ptr<Operation> Link::connect(const std::string& address, const TransportFactory& make,
                                         const ConnectOptions& options, bool reconnects) {
  auto operation = std::make_shared<Operation>(state_->bell);
  State& state = *state_;
  const auto connected = [&state](const auto& place, const auto& made) {
    const std::scoped_lock lock(state.mutex);
    state.*place = made;
    state.is_connected = !state.is_closed;
  };
  if (reconnects) {
    const auto client =
        std::make_shared<Reconnecting>(address, make, ReconnectOptions{.connection = options});
    operation->set_cancel([client] { client->close(); });
    add(operation);
    block(operation, [&state, client, connected] {
      state.changes = client->on_change([bell = state.bell](const auto&) { bell->ring(); });
      const Result<void> result = client->start();
      if (result) connected(&State::reconnecting, client);
      return [result] { return to_python(result); };
    });
    return operation;
  }
  operation->set_cancel([&state] {
    const std::scoped_lock lock(state.mutex);
    state.is_closed = true;
    if (state.conversation) state.conversation.close();
  });
  add(operation);
  block(operation, [&state, address, make, options, connected] {
    const auto opener =
        make ? detail::opener_of(make, options) : detail::opener_of(address, options);
    const auto begun = [&state](const detail::Conversation& conversation) {
      const std::scoped_lock lock(state.mutex);
      state.conversation = conversation;
      if (state.is_closed) conversation.close();
    };
    auto found = detail::connect(state.executor(), opener, options, begun);
    if (found) connected(&State::conversation, *found);
    const Result<void> result = found ? Result<void>() : std::move(found).error();
    return [result] { return to_python(result); };
  });
  return operation;
}

void Link::block(const std::shared_ptr<Operation>& operation,
                 std::function<Operation::Result()> work) {
  std::erase_if(state_->blocked, [](const std::future<void>& one) {
    return one.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
  state_->blocked.push_back(std::async(
      std::launch::async, [operation, work = std::move(work)] { operation->end(work()); }));
}

std::shared_ptr<Reconnecting> Link::reconnecting() const {
  if (process_ != getpid()) {
    raise_client({ErrorCode::invalid, "the client belongs to the process that forked this one"});
  }
  const std::scoped_lock lock(state_->mutex);
  if (!state_->is_connected) {
    raise_client({ErrorCode::not_connected, "the client is not connected"});
  }
  return state_->reconnecting;
}

detail::Conversation Link::conversation() const {
  if (const auto client = reconnecting()) {
    const auto current = client->current({});
    if (!current) raise_client(current.error());
    return detail::ClientMaker::conversation(**current);
  }
  const std::scoped_lock lock(state_->mutex);
  return state_->conversation;
}

bool Link::is_connected() const {
  if (const auto client = reconnecting()) return client->state() == LinkState::connected;
  return !conversation().state()->end_reason();
}

BoardIdentity Link::identity() const {
  const auto client = reconnecting();
  return client ? client->identity() : conversation().identity();
}

std::string Link::description() const {
  const auto client = reconnecting();
  return client ? client->description() : conversation().description();
}

std::shared_ptr<Operation> Link::begin() {
  static_cast<void>(conversation());
  return std::make_shared<Operation>(state_->bell, state_->time);
}

void Link::add(const std::shared_ptr<Operation>& operation) {
  const std::scoped_lock lock(state_->mutex);
  std::erase_if(state_->running, [](const auto& one) { return one.expired(); });
  state_->running.push_back(operation);
}

std::function<void()> Link::drive(const std::shared_ptr<Operation>& operation, TaskMachine& task,
                                  std::function<void()> done) {
  const auto driver = std::make_shared<detail::AsioDriver>(state_->executor(), conversation(), task,
                                                           std::move(done));
  const auto put = [weak = std::weak_ptr(driver)](detail::TaskDriver::Input input) {
    if (const auto running = weak.lock()) running->put(std::move(input));
  };
  operation->set_cancel([put] { put([](TaskMachine& one) { one.cancel(); }); });
  add(operation);
  driver->start();
  return [put] { put([](TaskMachine& one) { one.wake(); }); };
}

void Link::close() {
  if (process_ != getpid()) return;
  // A camera stops within this time, unless the line is lost.
  constexpr Duration patience = seconds(1);
  std::vector<std::weak_ptr<Operation>> running;
  detail::Conversation conversation;
  std::shared_ptr<Reconnecting> reconnecting;
  {
    const std::scoped_lock lock(state_->mutex);
    state_->is_connected = false;
    state_->is_closed = true;
    running.swap(state_->running);
    conversation = state_->conversation;
    reconnecting = state_->reconnecting;
  }
  const Instant until = now() + patience;
  for (const auto& weak : running) {
    if (const auto operation = weak.lock()) operation->cancel();
  }
  for (const auto& weak : running) {
    if (const auto operation = weak.lock()) operation->wait_until(until);
  }
  if (reconnecting) reconnecting->close();
  if (!conversation) return;
  conversation.close();
  // What the board hears last; otherwise, the thread sees to it.
  if (state_->time) state_->time->run([] { return false; }, now() + milliseconds(250));
}

}  // namespace sbgc::python
