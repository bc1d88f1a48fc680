/// A table of checks for every request: the emulated board's response, and the effect on its state.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <sbgc/availability.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>

#include "host.hpp"

namespace sbgc::test {

/// The board's behavior where the model leaves it open.
enum class Comes {
  as_modelled,  ///< the model leaves nothing open
  confirmation,
  nothing,
};

/// Fails unless the packets are exactly the responses announced by response_policy(request).
void expect_as_modelled(const ResponsePolicy& policy, const Packets& packets, Comes comes);

/// Returns the maximum time for all responses that the model announces.
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
    /// Checks the responses and the state of the board.
    std::function<void(Host&, const Packets&)> after{};
    emulator::BoardOptions options{};
  };

  template <Message M>
  void add(Entry<M> entry) {
    const auto& options = entry.options;
    if (!is_supported<M>(Availability{options.firmware.raw(), options.board.raw()})) {
      entry.options = newest_board();
    }
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
  void add_undocumented();
  void add_later_control();
  void add_external_motors();
  void add_later_parameters();
  void add_later_devices();

  std::multimap<std::string, Check> checks_;
};

/// Returns the only message M among the packets; fails the test otherwise.
template <class M>
M only(const Packets& packets) {
  const auto found = all<M>(packets);
  EXPECT_EQ(found.size(), 1U);
  return found.empty() ? M{} : found.front();
}

}  // namespace sbgc::test
