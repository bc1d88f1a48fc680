// The sbgc command: see `sbgc --help`.

#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "commands.hpp"

namespace {

/// What is opened later must not take the place of standard files that are closed. To read the
/// input, or to write the others, goes on to fail.
void hold_standard_files() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool is_open = fcntl(fd, F_GETFD) != -1;
    // The lowest free number is this one.
    if (!is_open && open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) == -1) return;
  }
}

}  // namespace

int main(int argc, char** argv) {
  namespace tools = sbgc::tools;
  int status = tools::success;
  hold_standard_files();
  try {
    CLI::App app("Tools for SimpleBGC gimbals and their serial protocol.", "sbgc");
    app.require_subcommand(1);
    app.set_help_all_flag("--help-all", "Print the help of all subcommands");
    tools::add_decode(app, status);
    tools::add_emulate(app, status);
    tools::add_encode(app, status);
    tools::add_ports(app, status);
    tools::add_record(app, status);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app.exit(error) == 0 ? tools::success : tools::wrong_usage;
    }
    // An earlier write that failed has left its mark, though nothing is left to be flushed.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw std::runtime_error("can not write to the standard output");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sbgc: %s\n", error.what());
    return tools::failure;
  }
  return status;
}
