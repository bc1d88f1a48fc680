#include "link.hpp"

#include <stdexcept>
#include <utility>

#include <asio/bind_executor.hpp>
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
  if (is_forked()) {
    static_cast<void>(state_.release());
    return;
  }
  close();
  state_->client.reset();
  state_->work.reset();  // what still runs ends soon, because the line is closed
  state_->thread.join();
}

std::shared_ptr<Operation> Link::connect(const std::string& address, const TransportFactory& make,
                                         const ConnectOptions& options, bool reconnects) {
  auto operation = std::make_shared<Operation>(state_->bell);
  State& state = *state_;
  state.client = std::make_unique<AsyncClient>(state.executor());
  operation->set_cancel([&client = *state.client] { client.close(); });
  add(operation);
  const auto connected = [&state, operation](const Result<void>& result) {
    {
      const std::scoped_lock lock(state.mutex);
      state.is_connected = result && !state.is_closed;
      if (state.is_connected) {
        state.changes = state.client->on_change([bell = state.bell](const auto&) { bell->ring(); });
      }
    }
    operation->end([result] { return to_python(result); });
  };
  const auto begin = [&](const auto& chosen) {
    // Virtual time does not pass until the board is found.
    auto token = asio::bind_executor(state.context, connected);
    if (make) return state.client->async_connect_over(make, chosen, token);
    state.client->async_connect(address, chosen, token);
  };
  if (reconnects) {
    begin(ReconnectOptions{.connection = options});
  } else {
    begin(options);
  }
  return operation;
}

bool Link::is_forked() const noexcept { return process_ != getpid(); }

AsyncClient& Link::client() const {
  if (is_forked()) {
    raise_client({ErrorCode::invalid, "the client belongs to the process that forked this one"});
  }
  if (!state_->is_connected) {
    raise_client({ErrorCode::not_connected, "the client is not connected"});
  }
  return *state_->client;
}

std::shared_ptr<Operation> Link::begin() {
  static_cast<void>(client());
  return std::make_shared<Operation>(state_->bell, state_->time);
}

void Link::add(const std::shared_ptr<Operation>& operation) {
  const std::scoped_lock lock(state_->mutex);
  std::erase_if(state_->running, [](const auto& one) { return one.expired(); });
  state_->running.push_back(operation);
}

void Link::close() {
  if (is_forked()) return;
  // A camera stops within this time, unless the line is lost.
  constexpr Duration patience = seconds(1);
  std::vector<std::weak_ptr<Operation>> running;
  {
    const std::scoped_lock lock(state_->mutex);
    state_->is_connected = false;
    state_->is_closed = true;
    running.swap(state_->running);
  }
  const Instant until = now() + patience;
  for (const auto& weak : running) {
    if (const auto operation = weak.lock()) operation->cancel();
  }
  for (const auto& weak : running) {
    if (const auto operation = weak.lock()) operation->wait_until(until);
  }
  if (!state_->client) return;
  state_->client->close();
  // What the board hears last; otherwise, the thread sees to it.
  if (state_->time) state_->time->run([] { return false; }, now() + milliseconds(250));
}

}  // namespace sbgc::python
