/// Objects that must not be used in a forked child.
#pragma once

#include <string>

#include <sys/types.h>
#include <unistd.h>

#include "binding.hpp"

namespace sbgc::python {

/// The process that made an object. A forked child has none of its threads, and its mutexes may be
/// locked for ever.
class Process {
 public:
  bool is_forked() const noexcept { return id_ != getpid(); }
  /// Raises in a forked child.
  void require(const char* what) const {
    if (!is_forked()) return;
    raise("GimbalError", std::string(what) + " belongs to the process that forked this one",
          "invalid", 0);
  }

 private:
  pid_t id_ = getpid();
};

}  // namespace sbgc::python
