/// What the emulated board answers, and what else has to follow: a table with checks for every
/// request.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>

#include "host.hpp"

namespace sbgc::test {

/// What a board does where the model leaves it open.
enum class Comes {
  as_modelled,  ///< nothing is open
  confirmation,
  nothing,
};

/// Fails unless the packets are what response_policy(request) announces, and nothing else.
void expect_as_modelled(const ResponsePolicy& policy, const Packets& packets, Comes comes);

/// How long all that the model announces takes at most.
Duration patience(const ResponsePolicy& policy);

using Check = std::function<void()>;

/// Checks by name of the request.
class Table {
 public:
  static const std::multimap<std::string, Check>& checks() {
    static const Table table;
    return table.checks_;
  }

 private:
  Table();

  template <Message M>
  struct Entry {
    M request{};
    Comes comes = Comes::as_modelled;
    /// Brings the board into the state that the request needs.
    std::function<void(Host&)> before{};
    /// Looks at what came, and at the board.
    std::function<void(Host&, const Packets&)> after{};
    emulator::BoardOptions options{};
  };

  template <Message M>
  void add(Entry<M> entry) {
    checks_.emplace(Meta<M>::info.name, [entry = std::move(entry)] {
      Host host(entry.options);
      if (entry.before) entry.before(host);
      const ResponsePolicy policy = response_policy(entry.request);
      const std::uint64_t restarts = host.board.counters().restarts;
      const Packets packets = host.ask(entry.request, patience(policy));
      expect_as_modelled(policy, packets, entry.comes);
      if (policy.restarts_board) host.listen(seconds(2));
      EXPECT_EQ(host.board.counters().restarts - restarts, policy.restarts_board ? 1U : 0U);
      if (entry.after) entry.after(host, packets);
    });
  }

  void add_system();
  void add_parameters();
  void add_live_data();
  void add_control();
  void add_calibration();
  void add_imu();
  void add_peripherals();
  void add_variables();
  void add_storage();
  void add_scripting_and_debug();

  std::multimap<std::string, Check> checks_;
};

/// The only message M of what came.
template <class M>
M only(const Packets& packets) {
  const auto found = all<M>(packets);
  EXPECT_EQ(found.size(), 1U);
  return found.empty() ? M{} : found.front();
}

}  // namespace sbgc::test
