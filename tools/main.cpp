// The sbgc command: see `sbgc --help`.

#include <cstdio>
#include <exception>

#include <CLI/CLI.hpp>

#include "commands.hpp"

int main(int argc, char** argv) {
  namespace tools = sbgc::tools;
  int status = tools::success;
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
