/// The error that ends a command.
#pragma once

#include <stdexcept>
#include <string>

namespace sbgc::tools {

/// Exit statuses of every subcommand.
enum ExitStatus : int {
  success = 0,
  failure = 1,        ///< it failed, or what it checks is not so
  wrong_usage = 2,    ///< the command line is invalid
  cannot_tell = 3,    ///< a comparison could not be made, or the board did not confirm it
  interrupted = 130,  ///< ended by Ctrl-C or another signal before it was done
};

/// Ends the command with a sentence for the user, without a final period.
class CommandError : public std::runtime_error {
 public:
  explicit CommandError(const std::string& message, int status = failure)
      : std::runtime_error(message), status_(status) {}

  int status() const noexcept { return status_; }

 private:
  int status_;
};

}  // namespace sbgc::tools
