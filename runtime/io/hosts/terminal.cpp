// A pseudo-terminal as an endpoint.

#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

#include <asio/error.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>

#include <sbgc/io/pseudo_terminal.hpp>

#include "hosts/endpoint.hpp"
#include "hosts/host.hpp"
#include "hosts/terminal_link.hpp"

namespace sbgc::hosts {

namespace {

/// There is no notification of changed settings: they are checked before each transfer and at this
/// interval.
constexpr auto look_every = std::chrono::milliseconds(50);

class Terminal final : public Endpoint {
 public:
  Terminal(asio::any_io_executor executor, HostPorts& board, std::string link, bool has_rate,
           Log warn)
      : executor_(std::move(executor)),
        board_(board),
        timer_(executor_),
        warn_(std::move(warn)),
        link_name_(std::move(link)),
        has_rate_(has_rate) {
    open();
  }

  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() override {
    if (host_ == nullptr) return;
    host_->before_bytes = nullptr;
    host_->close();
  }

  std::string address() const override {
    return link_ ? path_ + " (also " + link_->path() + ")" : path_;
  }

 private:
  /// Throws std::runtime_error.
  void open() {
    io::PseudoTerminalResult opened = io::open_pseudo_terminal(executor_, {.stays_open = true});
    if (!opened) throw std::runtime_error(opened.error.message);
    terminal_ = opened.transport.get();
    has_ended_ = false;
    path_ = terminal_->path();
    link_.reset();
    if (!link_name_.empty()) link_.emplace(link_name_, path_);
    host_ = Host::connect(board_, std::move(opened.transport));
    if (host_ == nullptr) throw std::runtime_error("the board has no free port");
    board_.keep_place(host_->port());
    if (has_rate_) {
      host_->before_bytes = [this](std::size_t) { look(); };
      keep_looking();
    }
    // Programs open and close the terminal; the terminal stays.
    host_->on_end = [this](std::error_code error) { ended(error); };
    host_->start();
  }

  void ended(std::error_code error) {
    has_ended_ = true;
    timer_.cancel();
    if (error && error != asio::error::timed_out) {
      return warn_(fmt::format("{} no longer works: {}", path_, error.message()));
    }
    // The program had to leave, which only the end of the terminal tells it.
    asio::post(executor_, [this] { open_again(); });
  }

  void open_again() {
    const std::string before = path_;
    try {
      open();
      warn_(fmt::format("{} was closed for its program; now there is {}", before, address()));
    } catch (const std::runtime_error& error) {
      warn_(fmt::format("{} was closed for its program: {}", before, error.what()));
    }
  }

  void look() {
    const std::optional<LineSettings> now = terminal_->other_line();
    const std::uint32_t rate = now ? now->baud_rate : 0;
    if (rate == rate_) return;
    rate_ = rate;
    board_.set_host_rate(host_->port(), rate);
  }

  void keep_looking() {
    if (has_ended_) return;  // another host may have the port
    look();
    timer_.expires_after(look_every);
    timer_.async_wait([this](std::error_code error) {
      if (!error) keep_looking();
    });
  }

  asio::any_io_executor executor_;
  HostPorts& board_;
  asio::steady_timer timer_;
  Log warn_;
  std::string link_name_;
  bool has_rate_;
  io::PseudoTerminal* terminal_ = nullptr;  // the host's transport
  std::string path_;
  std::optional<TerminalLink> link_{};
  std::shared_ptr<Host> host_;
  std::uint32_t rate_ = 0;
  bool has_ended_ = false;
};

}  // namespace

std::unique_ptr<Endpoint> open_terminal(const asio::any_io_executor& executor, HostPorts& board,
                                        const std::string& link, bool has_rate,
                                        const EndpointLogs& logs) {
  return std::make_unique<Terminal>(executor, board, link, has_rate, logs.warning);
}

}  // namespace sbgc::hosts
