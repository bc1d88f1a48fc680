// For every request of the model, the emulated board's response matches the model and the board's
// state changes accordingly. A request without an entry in the table needs no more than the model
// says.

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/availability.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/roles.hpp>

#include "answers/table.hpp"
#include "replies.hpp"

namespace sbgc::test {

void expect_as_modelled(const ResponsePolicy& policy, const Packets& packets, Comes comes) {
  unsigned confirmations = 0, answers = 0;
  for (const Packet& one : packets) {
    const Frame frame{one.id, one.body};
    const ResponseForm* const answer = policy.responses.form_of(frame);
    if (answer != nullptr) {
      ++answers;
      EXPECT_FALSE(answer->is_error) << "the request could have been executed";
    } else if (roles::is_confirmation(frame)) {
      ++confirmations;
      EXPECT_TRUE(policy.responses.is_confirmed_by(roles::confirmed_command(frame), frame));
      EXPECT_FALSE(policy.result.is_failure(one.body));
    } else if (policy.series != 0 && frame.id == policy.series) {
      EXPECT_EQ(answers, 0U) << "the response ends the series";
    } else if (roles::is_reset(frame)) {
      EXPECT_TRUE(policy.restarts_board) << "unexpected restart";
    } else if (one.id == policy.responses.command) {
      // The model does not say that it is a response, but it has the id of the request.
    } else {
      ADD_FAILURE() << "command " << int{one.id} << " is not a response to it";
    }
  }
  EXPECT_EQ(answers, policy.response_required ? 1U : 0U);
  switch (policy.responses.confirmed) {
    case Confirmed::never:
    case Confirmed::unlikely: EXPECT_EQ(confirmations, 0U); break;
    case Confirmed::always: EXPECT_EQ(confirmations, policy.confirmations); break;
    case Confirmed::possible:
      ASSERT_NE(comes, Comes::as_modelled)
          << "the model leaves it open: say in answers/ what the emulated board does";
      EXPECT_EQ(confirmations, comes == Comes::confirmation ? policy.confirmations : 0U);
      break;
  }
}

Duration patience(const ResponsePolicy& policy) {
  // How long a series takes depends on the request: the one here is over sooner.
  if (policy.series != 0) return seconds(10);
  return milliseconds(std::max(policy.timeout_ms, policy.finish_ms));
}

Table::Table() {
  add_system();
  add_parameters();
  add_live_data();
  add_control();
  add_calibration();
  add_imu();
  add_peripherals();
  add_variables();
  add_storage();
  add_scripting_and_debug();
  add_undocumented();
  add_later_control();
  add_external_motors();
  add_later_parameters();
  add_later_devices();
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) {
      if (!checks_.contains(Meta<M>::info.name)) add<M>({});
    }
  });
}

namespace {

std::vector<std::string> requests() {
  std::vector<std::string> names;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) names.emplace_back(Meta<M>::info.name);
  });
  return names;
}

class Answers : public ::testing::TestWithParam<std::string> {};

TEST_P(Answers, AreWhatTheModelSays) {
  const auto [begin, end] = Table::checks().equal_range(GetParam());
  ASSERT_NE(begin, end);
  for (auto check = begin; check != end; ++check) {
    SCOPED_TRACE("check " + std::to_string(std::distance(begin, check) + 1));
    check->second();
  }
}

INSTANTIATE_TEST_SUITE_P(Requests, Answers, ::testing::ValuesIn(requests()),
                         [](const auto& one) { return one.param; });

TEST(Answers, EveryCheckIsOfARequest) {
  const auto names = requests();
  const std::set<std::string> known(names.begin(), names.end());
  for (const auto& [name, check] : Table::checks()) EXPECT_TRUE(known.contains(name)) << name;
}

TEST(Answers, AnOldBoardRefusesWhatItDoesNotKnow) {
  emulator::BoardOptions old;
  old.board = msg::BoardVersion(30);
  old.firmware = msg::FirmwareVersion(2439);
  old.is_strict = true;  // a later form may also be an earlier one with surplus
  const Availability versions{2439, 30};
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) {
      if (is_supported<M>(versions)) return;
      SCOPED_TRACE(Meta<M>::info.name);
      Host host(old);
      const auto reason = refusal(host, any_request<M>());
      EXPECT_TRUE(reason == msg::BoardErrorCode::unknown_command ||
                  reason == msg::BoardErrorCode::cmd_size);
    }
  });
}

}  // namespace
}  // namespace sbgc::test
