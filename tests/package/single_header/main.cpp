#include <cstdio>

#include "ask.hpp"

int main() {
  static sbgc::Session session;
  const bool answered = ask(session) == sbgc::Outcome::answered;
  std::puts(answered ? "the board has answered" : "the session does not work");
  return answered ? 0 : 1;
}
