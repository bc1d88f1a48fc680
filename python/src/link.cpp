#include "link.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <asio/bind_executor.hpp>
#include <sys/eventfd.h>

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
  const char* const type = [&] {
    switch (error.code) {
      case ErrorCode::timeout: return "GimbalTimeout";
      case ErrorCode::link_lost:
      case ErrorCode::not_connected: return "GimbalDisconnected";
      case ErrorCode::superseded: return "GimbalSuperseded";
      case ErrorCode::interrupted: return "GimbalInterrupted";
      default: return "GimbalError";
    }
  }();
  raise(type, error.message, name(error.code), error.detail);
}

namespace {

/// A camera stops within this time, unless the line is lost.
constexpr Duration patience = seconds(1);

}  // namespace

Link::Link() : state_(std::make_unique<State>()) {
  state_->thread = std::thread([&context = state_->context] { context.run(); });
}

Link::~Link() {
  if (is_forked()) {
    static_cast<void>(state_.release());
    return;
  }
  const auto end = [&] {
    close(now() + patience);
    state_->client.reset();
    state_->work.reset();  // running work ends soon, because the line is closed
    state_->thread.join();
    return true;
  };
  // Other Python threads run meanwhile; at the end of the interpreter, there are none.
  if (PyGILState_Check() == 0 || Py_IsInitialized() == 0) {
    end();
  } else {
    released(end);
  }
}

std::shared_ptr<Operation> Link::connect(const std::string& address, const TransportFactory& make,
                                         const ConnectOptions& options, bool reconnects) {
  auto operation = std::make_shared<Operation>(state_->bell);
  State& state = *state_;
  operation->set_begin(
      [this, &state, address, make, options, reconnects](const std::shared_ptr<Operation>& one) {
        state.client = std::make_unique<AsyncClient>(state.executor());
        one->set_cancel([&client = *state.client] { client.close(); });
        add(one);
        const auto connected = [&state, one](const Result<void>& result) {
          {
            const std::scoped_lock lock(state.mutex);
            state.is_connected = result && !state.is_closed;
          }
          if (state.is_connected) {
            state.changes = state.client->on_change([&state](const LinkChange& change) {
              state.happened(name(change.state), change.message);
            });
            state.notices = state.client->on_notice(
                [&state](const Notice& notice) { state.happened("notice", notice.message); });
            state.happened("connected", state.client->description());
          }
          one->end([result] { return to_python(result); });
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
      });
  return operation;
}

AsyncClient& Link::client() const {
  require_this_process();
  if (!state_->is_connected) {
    raise_client({ErrorCode::not_connected, state_->is_closed ? "the client has been closed"
                                                              : "the client is not connected"});
  }
  return *state_->client;
}

bool Link::is_connected() const {
  require_this_process();
  return state_->is_connected && state_->client->is_connected();
}

std::shared_ptr<Operation> Link::make_operation() {
  static_cast<void>(client());
  return std::make_shared<Operation>(state_->bell, state_->time);
}

void Link::add(const std::shared_ptr<Operation>& operation) {
  const std::scoped_lock lock(state_->mutex);
  std::erase_if(state_->running, [](const auto& one) { return one.expired(); });
  state_->running.push_back(operation);
}

void Link::begin_close() {
  if (is_forked()) return;
  std::vector<std::weak_ptr<Operation>> running;
  {
    const std::scoped_lock lock(state_->mutex);
    state_->is_connected = false;
    state_->is_closed = true;
    running = state_->running;
  }
  for (const auto& weak : running) {
    if (const auto operation = weak.lock()) operation->cancel();
  }
}

bool Link::is_still() const {
  if (is_forked()) return true;
  const std::scoped_lock lock(state_->mutex);
  return std::ranges::all_of(state_->running, [](const auto& weak) {
    const auto operation = weak.lock();
    return !operation || operation->is_over();
  });
}

void Link::close(Instant until) {
  if (is_forked()) return;
  begin_close();
  std::vector<std::weak_ptr<Operation>> running;
  {
    const std::scoped_lock lock(state_->mutex);
    running.swap(state_->running);
  }
  for (const auto& weak : running) {
    if (const auto operation = weak.lock()) operation->wait_until(until);
  }
  if (!state_->client) return;
  state_->client->close();
  // The last command to the board; otherwise, the thread sends it.
  if (state_->time) state_->time->run([] { return false; }, now() + milliseconds(250));
}

Link::Events Link::take_events() {
  if (is_forked()) return {};
  Events events;
  {
    const std::scoped_lock lock(state_->mutex);
    events.swap(state_->events);
  }
  const std::uint64_t retries = state_->client ? state_->client->statistics().session.retries : 0;
  const std::uint64_t before = std::exchange(retries_, retries);
  if (retries > before) {
    const std::uint64_t count = retries - before;
    events.emplace_back("retried", count == 1 ? "a request without an answer was sent again"
                                              : "requests without an answer were sent again, " +
                                                    std::to_string(count) + " times");
  }
  return events;
}

}  // namespace sbgc::python
