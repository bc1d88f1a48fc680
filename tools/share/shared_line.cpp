#include "share/shared_line.hpp"

#include <chrono>
#include <utility>

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

}  // namespace sbgc::tools
