// Tests of events: each is sent once, to the hosts that want it.

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using EventKind = msg::EventType;

void subscribe(Host& host, msg::EventId id,
               msg::EventTypes types = EventKind::on | EventKind::off) {
  msg::DataStreamInterval request;
  request.cmd_id = msg::CommandFromBoard::event;
  request.interval_ms = msg::Milliseconds(1);
  request.config.event_id = id;
  request.config.event_type = types;
  EXPECT_TRUE(is_confirmed(host, request));
}

/// The events during some time, as text.
std::vector<std::string> events_of(Host& host, const Packets& packets, Duration time) {
  std::vector<std::string> result;
  const auto add = [&](const Packets& some) {
    for (const msg::Event& event : all<msg::Event>(some)) {
      result.push_back(std::to_string(static_cast<int>(event.event_id)) +
                       (event.event_type.has(EventKind::on) ? " on" : " off"));
    }
  };
  add(packets);
  add(host.listen(time));
  return result;
}

TEST(Events, TellTheStateOfTheMotors) {
  Host host(newest_board());
  subscribe(host, msg::EventId::motor_state);
  EXPECT_THAT(events_of(host, host.ask(msg::MotorsOffExt{}), seconds(1)),
              ::testing::ElementsAre("2 off"));
  EXPECT_THAT(events_of(host, host.ask(msg::MotorsOn{}), seconds(1)),
              ::testing::ElementsAre("2 on"));
  EXPECT_THAT(events_of(host, host.ask(msg::MotorsOn{}), seconds(1)), IsEmpty()) << "no change";
}

TEST(Events, OnlyTheKindsThatAreWanted) {
  Host host(newest_board());
  subscribe(host, msg::EventId::motor_state, EventKind::on);
  EXPECT_THAT(events_of(host, host.ask(msg::MotorsOffExt{}), seconds(1)), IsEmpty());
  EXPECT_THAT(events_of(host, host.ask(msg::MotorsOn{}), seconds(1)), SizeIs(1));
  EXPECT_THAT(
      events_of(host, host.ask(msg::ExecuteMenu{msg::MenuCommand::camera_photo_event}), seconds(1)),
      IsEmpty())
      << "another event";
}

TEST(Events, AnEmptyBatteryIsAnEmergencyStop) {
  Host host(newest_board());
  subscribe(host, msg::EventId::emergency_stop);
  subscribe(host, msg::EventId::motor_state);
  host.board.gimbal().set_battery(9, host.now);
  EXPECT_THAT(events_of(host, {}, seconds(3)), ::testing::ElementsAre("2 off", "3 on"));
}

TEST(Events, OfButtonCameraAndPosition) {
  Host host(newest_board());
  subscribe(host, msg::EventId::menu_button);
  subscribe(host, msg::EventId::camera);
  subscribe(host, msg::EventId::retracted_position);
  EXPECT_THAT(
      events_of(host, host.ask(msg::ExecuteMenu{msg::MenuCommand::button_press}), seconds(1)),
      ::testing::ElementsAre("1 on", "1 off"));
  EXPECT_THAT(
      events_of(host, host.ask(msg::ExecuteMenu{msg::MenuCommand::camera_photo_event}), seconds(1)),
      ::testing::ElementsAre("4 on"));
  EXPECT_THAT(
      events_of(host, host.ask(msg::ExecuteMenu{msg::MenuCommand::retracted_position}), seconds(1)),
      ::testing::ElementsAre("6 on"));
  EXPECT_THAT(events_of(host, host.ask(msg::Control{}), seconds(1)),
              ::testing::ElementsAre("6 off"));
}

TEST(Events, AScriptStartsAndEnds) {
  Host host(newest_board());
  msg::WriteFile script;
  const std::string_view text = "one\ntwo\n";
  script.file_size = msg::ByteCount(static_cast<std::uint16_t>(text.size()));
  for (const char c : text) script.data.push_back(static_cast<std::uint8_t>(c));
  host.ask(script);
  subscribe(host, msg::EventId::script);
  EXPECT_THAT(events_of(host, host.ask(msg::RunScript{.mode = msg::ScriptMode::start}), seconds(1)),
              ::testing::ElementsAre("5 on", "5 off"));
}

TEST(Events, EndWithTheirStream) {
  Host host(newest_board());
  subscribe(host, msg::EventId::motor_state);
  msg::DataStreamInterval end;
  end.cmd_id = msg::CommandFromBoard::event;
  end.config.event_id = msg::EventId::motor_state;
  end.config.event_type = EventKind::on | EventKind::off;
  EXPECT_TRUE(is_confirmed(host, end));
  EXPECT_THAT(events_of(host, host.ask(msg::MotorsOffExt{}), seconds(1)), IsEmpty());
}

TEST(Events, EarlierFirmwareHasFewer) {
  emulator::BoardOptions options;
  options.firmware = msg::FirmwareVersion(2656);
  Host host(options);
  msg::DataStreamInterval request;
  request.cmd_id = msg::CommandFromBoard::event;
  request.interval_ms = msg::Milliseconds(1);
  request.config.event_id = msg::EventId::motor_state;
  request.config.event_type = msg::EventTypes{};
  EXPECT_EQ(refusal(host, request), msg::BoardErrorCode::wrong_params);
}

}  // namespace
}  // namespace sbgc::test
