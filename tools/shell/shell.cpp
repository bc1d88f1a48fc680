// sbgc shell: one command after another on one connection.

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "board/connection.hpp"
#include "bytes/secret_words.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"
#include "move/guard.hpp"
#include "shell/completion.hpp"
#include "shell/line_editor.hpp"
#include "shell/scripts.hpp"
#include "shell/shell_line.hpp"

namespace sbgc::tools {

namespace {

constexpr const char* name_of_shell = "shell";

// One for the process, as its signal handlers are.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t end_signal = 0;
volatile std::sig_atomic_t was_key_pressed = 0;
volatile std::sig_atomic_t running_command = 0;  // its process
volatile std::sig_atomic_t early_signal = 0;     // came before the command
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

extern "C" void take_key(int) { was_key_pressed = 1; }
extern "C" void pass_signal_on(int number, siginfo_t* sender, void*) {
  if (number == SIGTERM || number == SIGHUP) end_signal = number;
  if (number == SIGINT) take_key(number);
  // The keys of a terminal signal the command, too; a process may mean the shell alone.
  const bool is_key = (number == SIGINT || number == SIGQUIT) && sender->si_code > 0;
  if (running_command == 0) {
    early_signal = number;
  } else if (!is_key) {
    ::kill(running_command, number);
  }
}

/// While it exists, signals for this program end the running command first, because the line
/// carries its stop. After SIGTERM and SIGHUP, the shell ends, too; the keys of a terminal are only
/// for the command.
class SignalsOfCommand {
 public:
  SignalsOfCommand() {
    early_signal = 0;
    for (std::size_t i = 0; i < signals.size(); ++i) {
      struct sigaction action {};
      const int number = signals[i];
      ::sigaction(number, nullptr, &before_[i]);
      if (number == SIGHUP && before_[i].sa_handler == SIG_IGN) continue;  // nohup
      if (number == SIGTSTP) {
        action.sa_handler = SIG_IGN;
      } else {
        action.sa_sigaction = pass_signal_on;
        action.sa_flags = SA_SIGINFO;
      }
      ::sigaction(number, &action, nullptr);
    }
  }
  SignalsOfCommand(const SignalsOfCommand&) = delete;
  SignalsOfCommand& operator=(const SignalsOfCommand&) = delete;
  ~SignalsOfCommand() {
    for (std::size_t i = 0; i < signals.size(); ++i) {
      ::sigaction(signals[i], &before_[i], nullptr);
    }
  }

 private:
  static constexpr std::array signals{SIGINT, SIGQUIT, SIGTSTP, SIGTERM, SIGHUP};
  std::array<struct sigaction, signals.size()> before_{};
};

/// The result of a command.
struct Ended {
  int status = failure;
  bool is_killed = false;
};

/// Runs this program with these arguments, while SignalsOfCommand exists. With `has_input`, it
/// reads the input of the shell. It describes its line as `line`, unless that is empty.
Ended run_command(const std::vector<std::string>& arguments, bool has_input,
                  const std::string& line = "") {
  std::string name = "sbgc";
  std::vector<std::string> copies = arguments;
  std::vector<char*> pointers{name.data()};
  for (std::string& copy : copies) pointers.push_back(copy.data());
  pointers.push_back(nullptr);
  std::string line_variable = fmt::format("{}={}", shell_line_variable, line);
  std::vector<char*> environment;
  if (!line.empty()) environment.push_back(line_variable.data());
  for (char** one = environ; *one != nullptr; ++one) environment.push_back(*one);
  environment.push_back(nullptr);
  posix_spawn_file_actions_t files{};
  posix_spawn_file_actions_init(&files);
  if (!has_input) posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
  posix_spawnattr_t attributes{};
  posix_spawnattr_init(&attributes);
  sigset_t usual{};
  sigemptyset(&usual);
  sigaddset(&usual, SIGQUIT);
  for (const int number : asking_signals()) sigaddset(&usual, number);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t process = -1;
  const int error = ::posix_spawn(&process, "/proc/self/exe", &files, &attributes, pointers.data(),
                                  environment.data());
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) {
    throw CommandError(fmt::format("the command cannot be started: {}", std::strerror(error)));
  }
  running_command = process;
  if (early_signal != 0) ::kill(process, early_signal);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  running_command = 0;
  if (WIFEXITED(status)) return {WEXITSTATUS(status), false};
  return {interrupted, true};
}

/// Returns the files and folders whose names begin with the word.
std::vector<std::string> files_from(const std::string& word) {
  namespace fs = std::filesystem;
  const std::string folder = word.substr(0, word.rfind('/') + 1);
  std::vector<std::string> result;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, failed)) {
    const std::string file = entry.path().filename().string();
    const std::string name = folder + file;
    const bool is_hidden = file.starts_with('.') && word == folder;
    std::error_code ignored;
    if (!name.starts_with(word) || is_hidden || clipped(name) != name) continue;
    result.push_back(entry.is_directory(ignored) ? name + '/' : name);
  }
  return result;
}

/// True if the words name their own gimbal.
bool has_own_gimbal(const std::vector<std::string>& words) {
  for (const std::string_view word : words) {
    for (const std::string_view option : {"-p", "-g", "--port", "--gimbal"}) {
      const bool is_long = option.starts_with("--");
      if (word == option || (is_long ? word.starts_with(std::string(option) + '=')
                                     : word.starts_with(option) && !word.starts_with("--"))) {
        return true;
      }
    }
  }
  return false;
}

class CommandShell {
 public:
  CommandShell(const CLI::App& app, const GimbalOptions& gimbal)
      : app_(app), gimbal_(with_configuration(gimbal)) {
    is_verbose_ = std::exchange(gimbal_.verbose, false);  // the commands print their frames
    gimbal_.name.clear();                                 // its options are here
    line_.emplace(gimbal_);
  }

  int run() {
    LineEditor editor("sbgc> ", [this](std::string_view line) { return complete(line); });
    if (editor.is_interactive()) {
      struct sigaction action {};
      action.sa_handler = take_key;
      ::sigaction(SIGINT, &action, nullptr);
      greet();
      tell("`help` lists the commands; Ctrl-D or `exit` ends.");
    }
    for (std::size_t number = 1;; ++number) {
      const std::optional<std::string> line = editor.read();
      if (!line) return success;
      int status = success;
      try {
        if (line->find('\0') != std::string::npos) {
          throw CommandError(fmt::format("line {} has a NUL byte: it is no text in UTF-8", number));
        }
        Words words = split_words(*line);
        refuse_secrets(words.words);  // before they reach the history or another process
        editor.keep(*line);
        if (!words.is_complete) throw CommandError("a quote has no end", wrong_usage);
        if (!words.words.empty() && words.words.front() == "sbgc") {
          words.words.erase(words.words.begin());
        }
        if (words.words.empty()) continue;
        if (words.words.front() == "exit" || words.words.front() == "quit") return success;
        was_key_pressed = 0;
        status = execute(words.words, editor.is_interactive());
        if (was_key_pressed != 0) remark_as_is("\n");  // after the ^C that the terminal shows
      } catch (const CommandError& error) {
        remark_failure(as_message(error.what()));
        status = error.status();
      }
      if (end_signal != 0) return interrupted;
      if (status == success || editor.is_interactive()) continue;
      remark_failure(fmt::format("line {} failed; what follows was not run", number));
      return status;
    }
  }

 private:
  static void tell(const std::string& text) { remark("{}\n", wrapped(text, line_width(stderr))); }
  void greet() { tell(line_->description()); }

  std::vector<std::string> complete(std::string_view line) const {
    Words typed = split_typed(line);
    if (typed.words.size() > 1 && typed.words.front() == "sbgc") {
      typed.words.erase(typed.words.begin());
    }
    std::vector<std::string> result;
    for (const Candidate& candidate : candidates_for(app_, typed.words)) {
      if (candidate.word != files_directive) {
        result.push_back(candidate.word);
        continue;
      }
      for (std::string& file : files_from(typed.words.back())) result.push_back(std::move(file));
    }
    return result;
  }

  int execute(const std::vector<std::string>& words, bool has_input) {
    const CLI::App& command = command_of(app_, words);
    if (command.get_name() == name_of_shell) throw CommandError("this is the shell", wrong_usage);
    if (line_) line_->report_changes();
    const bool needs_line =
        command.get_option_no_throw("--port") != nullptr && !has_own_gimbal(words);
    if (!needs_line || command.get_parent() == nullptr) {
      const SignalsOfCommand signals;
      return run_command(words, has_input).status;
    }
    require_line();
    std::vector<std::string> arguments = options();
    arguments.insert(arguments.end(), words.begin(), words.end());
    // Longer than the guard: a signal must not end this process before it releases the guard.
    const SignalsOfCommand signals;
    // The guard of a command holds a place, which ends with this process.
    std::optional<Guard> guard;
    if (command.get_group() == "Move") {
      guard.emplace();
      if (!line_->hand_line_to(*guard)) guard.reset();
    }
    line_->set_running(true);
    const Ended ended = run_command(arguments, has_input, line_->line());
    line_->close_place(ended.is_killed);
    line_->set_running(false);
    if (ended.is_killed && end_signal != 0 && guard) {
      line_.reset();  // so that only the guard holds the line
      guard->leave_it_to_guard();
    }
    return ended.status;
  }

  /// Reconnects if the connection is lost. Throws CommandError.
  void require_line() {
    if (line_ && line_->is_connected()) return;
    remark("sbgc: connecting again ...\n");
    if (line_ && line_->wait_until_connected()) return line_->report_changes();
    line_.reset();
    line_.emplace(gimbal_);
    greet();
  }

  /// Returns the options of a command, with a place for it.
  std::vector<std::string> options() {
    std::vector<std::string> result{"--port", line_->open_place()};
    const auto add = [&](const char* option, const std::string& value) {
      result.emplace_back(option);
      result.push_back(value);
    };
    if (gimbal_.timeout) add("--timeout", fmt::format("{}ms", gimbal_.timeout->count()));
    if (gimbal_.attempts) add("--attempts", std::to_string(*gimbal_.attempts));
    if (gimbal_.attempt_timeout) {
      add("--attempt-time", fmt::format("{}ms", gimbal_.attempt_timeout->count()));
    }
    if (is_verbose_) result.emplace_back("--verbose");
    return result;
  }

  const CLI::App& app_;
  GimbalOptions gimbal_;
  bool is_verbose_ = false;
  std::optional<ShellLine> line_{};
};

}  // namespace

void add_shell(CLI::App& app, CommandContext& context) {
  const Subcommand<NoOptions> command(app, context, name_of_shell,
                                      "Run one command after another on one connection");
  command->footer(
      "The shell takes the commands of sbgc, with or without 'sbgc' in front, and keeps the "
      "connection open between them. A command with its own --port or --gimbal uses another "
      "connection. Words are split and quoted as in a POSIX shell; # begins a comment. On a "
      "terminal, Tab completes, the history is in ~/.local/state/sbgc/history, Ctrl-C ends a "
      "command, and Ctrl-D ends the shell. If the connection is lost, the shell says so, and the "
      "next command reconnects. Commands that move the camera or write to the board still ask.\n"
      "\n"
      "Without a terminal, it reads commands from standard input and stops at the first failure; "
      "commands that would ask need --yes. The exit status is 0 if all commands succeeded or "
      "were typed, that of the first failure, 1 if there is no connection, 2 for wrong usage.\n"
      "\n"
      "Examples:\n"
      "  sbgc shell\n"
      "  sbgc shell -p /dev/ttyUSB0 < commands");
  command.runs([&app](const NoOptions&, const CommandContext& shared) {
    return CommandShell(app, shared.gimbal).run();
  });
}

}  // namespace sbgc::tools
