#include "share/shared_line.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include <asio/post.hpp>

#include <sbgc/io/clock.hpp>

namespace sbgc::tools {

namespace {

/// A request that has waited longer is useless to its host.
constexpr std::chrono::milliseconds longest_wait{2'000};

}  // namespace

SharedLine::SharedLine(asio::io_context& context, const GimbalOptions& gimbal, Settings settings)
    : settings_(std::move(settings)),
      gate_(
          [this, executor = context.get_executor()](LineGate::Bytes bytes) {
            asio::post(executor, [this, bytes = std::move(bytes)] { ports_.raw_arrived(bytes); });
          },
          [this, executor = context.get_executor()] {
            asio::post(executor, [this] { ports_.raw_sent(); });
          }),
      line_(context.get_executor(), connect(gimbal), gate_),
      ports_(line_, io::now, settings_.log, settings_.allows_passwords) {
  line_.begin(ports_, [this](const LinkChange& change) { changed(change); });
}

Client SharedLine::connect(const GimbalOptions& gimbal) {
  return connect_for_long(gimbal, [this](ConnectOptions& options) {
    if (options.password && !settings_.allows_passwords) {
      throw CommandError(
          "the password opens the gimbal for every program that can connect to the bridge; "
          "--allow-passwords agrees to that",
          wrong_usage);
    }
    options.queue_timeout = longest_wait;
    options.wrap = [this, wrap = options.wrap](std::unique_ptr<io::Transport> transport) {
      if (settings_.wrap) transport = settings_.wrap(std::move(transport));
      return gate_.pass(wrap ? wrap(std::move(transport)) : std::move(transport));
    };
  });
}

void SharedLine::changed(const LinkChange& change) {
  const bool is_lost = change.state == LinkState::lost;
  const bool is_news = !is_lost || ports_.line_lost();
  if (is_news) settings_.on_change(change);
  if (change.state == LinkState::connected) ports_.restart_streams();
}

namespace {

/// A copy of a frame.
struct OwnFrame {
  explicit OwnFrame(const Frame& from)
      : id(from.id), body(from.body.begin(), from.body.end()), framing(from.framing) {}

  Frame frame() const { return {.id = id, .body = body, .framing = framing}; }

  std::uint8_t id;
  std::vector<std::uint8_t> body;
  Framing framing;
};

}  // namespace

BridgeClient::BridgeClient(asio::any_io_executor executor, Client client, LineGate& gate)
    : executor_(std::move(executor)), gate_(gate), client_(std::move(client)) {}

BridgeClient::~BridgeClient() {
  stopper_.request_stop();
  client_.close();
}

void BridgeClient::begin(BridgePorts& ports, std::function<void(const LinkChange&)> on_change) {
  ports_ = &ports;
  on_change_ = std::move(on_change);
  frames_ = client_.on_frame([this](const BoardFrame& arrived) {
    asio::post(executor_,
               [this, own = OwnFrame(arrived.frame), copy = BoardFrame(arrived)]() mutable {
                 copy.frame = own.frame();
                 ports_->arrived(copy);
               });
  });
  changes_ = client_.on_change([this](const LinkChange& change) {
    asio::post(executor_, [this, change] { on_change_(change); });
  });
}

void BridgeClient::send(std::uint64_t tag, RawRequest request) {
  request.on_frame = [this, tag](const Frame& frame) {
    asio::post(executor_,
               [this, tag, own = OwnFrame(frame)] { ports_->answered(tag, own.frame()); });
  };
  // The host repeats its requests if necessary.
  client_.start_raw(std::move(request), {.retries = 0}, [this, tag](const Result<Reply>& reply) {
    const auto failure = reply ? std::nullopt : std::optional(reply.error().code);
    asio::post(executor_, [this, tag, failure] { ports_->ended(tag, failure); });
  });
}

void BridgeClient::take_over(OwedStop stop) {
  {
    const std::lock_guard lock(stops_mutex_);
    const auto is_same = [&](const OwedStop& one) {
      return one.turns_motors_off() == stop.turns_motors_off();
    };
    if (std::ranges::none_of(stops_, is_same)) stops_.push_back(std::move(stop));
  }
  stops_changed_.notify_one();
  if (stopper_.joinable()) return;
  stopper_ = std::jthread([this](const std::stop_token& end) { go_on_with_stops(end); });
}

void BridgeClient::drop_stops() {
  const std::lock_guard lock(stops_mutex_);
  stops_.clear();
  ++drops_;
}

void BridgeClient::go_on_with_stops(const std::stop_token& end) {
  constexpr std::chrono::milliseconds pause{100};
  std::unique_lock lock(stops_mutex_);
  while (stops_changed_.wait(lock, end, [&] { return !stops_.empty(); })) {
    std::vector<OwedStop> now = std::exchange(stops_, {});
    const std::uint64_t drops = drops_;
    for (OwedStop& stop : now) {
      if (drops_ != drops) break;
      lock.unlock();
      const auto began = OwedStop::Clock::now();
      const Result<void> ended = client_.run(stop.attempt());
      const bool is_owed = stop.take(ended, began) == OwedStop::State::owed;
      lock.lock();
      if (is_owed && drops_ == drops) stops_.push_back(std::move(stop));
    }
    lock.unlock();
    std::this_thread::sleep_for(pause);
    lock.lock();
    if (end.stop_requested()) return;
  }
}

}  // namespace sbgc::tools
