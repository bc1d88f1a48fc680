// A pseudo-terminal as an endpoint.

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <asio/error.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <sbgc/io/pseudo_terminal.hpp>

#include "hosts/endpoint.hpp"
#include "hosts/host.hpp"

namespace sbgc::hosts {

namespace {

/// A symbolic link to a pseudo-terminal that exists as long as this object. Replaces only links
/// that an emulator left behind: those to a pseudo-terminal that is gone, or to this one.
class TerminalLink {
 public:
  /// Throws std::runtime_error if the link cannot be created or the name is in use.
  TerminalLink(std::string path, std::string terminal);
  TerminalLink(const TerminalLink&) = delete;
  TerminalLink& operator=(const TerminalLink&) = delete;
  /// Removes the link unless it was replaced.
  ~TerminalLink();

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::string terminal_;
};

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

/// Returns the reason why the link must not be replaced; "" if it may be.
std::string objection(const std::string& path, const std::string& terminal) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(path, error))) return "it exists and is not a link";
  const std::string target = fs::read_symlink(path, error).string();
  if (error) return reason(error.value());
  if (target == terminal) return "";
  if (!target.starts_with("/dev/pts/")) return "it is a link to " + target;
  if (fs::exists(fs::status(target, error))) {
    return "it is a link to " + target + ", which may be in use; remove it if it is not";
  }
  return "";
}

TerminalLink::TerminalLink(std::string path, std::string terminal)
    : path_(std::move(path)), terminal_(std::move(terminal)) {
  const auto fail = [&](const std::string& why) {
    throw std::runtime_error(fmt::format("the link {} cannot be created: {}", path_, why));
  };
  // Fails if the name exists.
  if (symlink(terminal_.c_str(), path_.c_str()) == 0) return;
  if (errno != EEXIST) fail(reason(errno));
  if (const std::string why = objection(path_, terminal_); !why.empty()) fail(why);
  // Atomic, so that the name always exists. A killed program may have left the other name.
  const std::string fresh = path_ + ".sbgc-new";
  if (symlink(terminal_.c_str(), fresh.c_str()) != 0) {
    if (errno != EEXIST) fail(reason(errno));
    if (const std::string why = objection(fresh, terminal_); !why.empty()) {
      fail(fmt::format("{}: {}", fresh, why));
    }
    unlink(fresh.c_str());
    if (symlink(terminal_.c_str(), fresh.c_str()) != 0) fail(reason(errno));
  }
  std::error_code error;
  fs::rename(fresh, path_, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(fresh, ignored);
  fail(reason(error.value()));
}

TerminalLink::~TerminalLink() {
  std::error_code error;
  if (fs::read_symlink(path_, error).string() == terminal_ && !error) fs::remove(path_, error);
}

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
    // The program had to leave, and only notices when the terminal is closed.
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
