#include <cstdio>

#include "sbgc.hpp"

/// Sends a request and feeds the session with its response; returns the outcome. In another file.
sbgc::Outcome ask(sbgc::Session& session);

int main() {
  static sbgc::Session session;
  const bool answered = ask(session) == sbgc::Outcome::answered;
  std::puts(answered ? "the board has answered" : "the session does not work");
  return answered ? 0 : 1;
}
