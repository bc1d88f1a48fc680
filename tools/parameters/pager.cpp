#include "parameters/pager.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <sys/wait.h>

#include "command/system.hpp"
#include "command/terminal_text.hpp"

namespace sbgc::tools {

namespace {

/// Returns the command line of the pager; "" for none.
std::string pager() {
  if (!is_terminal(stdout) || is_dumb_terminal()) return "";
  if (const char* const chosen = std::getenv("PAGER")) return chosen;
  return "if command -v less >/dev/null; then exec less -FRX; else exec cat; fi";
}

/// Ignores SIGPIPE from a pager that ends early, and Ctrl-C, which is for the pager.
class SignalsOfPager {
 public:
  SignalsOfPager() {
    for (std::size_t i = 0; i < signals.size(); ++i) before_[i] = std::signal(signals[i], SIG_IGN);
  }
  SignalsOfPager(const SignalsOfPager&) = delete;
  SignalsOfPager& operator=(const SignalsOfPager&) = delete;
  ~SignalsOfPager() {
    for (std::size_t i = 0; i < signals.size(); ++i) std::signal(signals[i], before_[i]);
  }

 private:
  static constexpr std::array signals{SIGINT, SIGQUIT, SIGPIPE};
  std::array<void (*)(int), signals.size()> before_{};
};

}  // namespace

void print_paged(const std::string& text) {
  const std::string command = pager();
  // NOLINTNEXTLINE(cert-env33-c): what runs is the choice of the user
  std::FILE* const pipe = command.empty() ? nullptr : ::popen(command.c_str(), "w");
  if (pipe == nullptr) return fmt::print("{}", text);
  const SignalsOfPager signals;
  std::fwrite(text.data(), 1, text.size(), pipe);
  const int status = ::pclose(pipe);
  constexpr int not_found = 127;  // exit status of the shell
  if (WIFEXITED(status) && WEXITSTATUS(status) == not_found) fmt::print("{}", text);
}

}  // namespace sbgc::tools
