// Tests of calls and of all the ways in which they end.

#include <sbgc/ostream.hpp>

#include "testing.hpp"

namespace sbgc::test {
namespace {

using std::chrono::steady_clock;

class Call : public ScriptedTest {
 protected:
  Client connect_to_firmware(std::uint16_t firmware, std::uint8_t version = 30) {
    introduce(board, firmware, version);
    return connect();
  }
};

TEST_F(Call, WaitsForTheConfirmation) {
  board.on<msg::MotorsOn>([&](const msg::MotorsOn& request) { board.confirm(request); });
  Client client = connect();
  const auto reply = checked(client.transact(msg::MotorsOn{}));
  EXPECT_EQ(reply->kind, ReplyKind::confirmed);
  EXPECT_TRUE(client.motors_on());
}

TEST_F(Call, ReportsEachOfSeveralConfirmations) {
  board.on<msg::CalibGyro>([&](const msg::CalibGyro& request) {
    board.confirm(request);
    board.confirm(request);
  });
  Client client = connect();
  std::vector<unsigned> numbers;
  const auto result = client.calib_gyro(
      {}, {.timeout = std::chrono::seconds(60),
           .on_confirmation = [&](unsigned number) { numbers.push_back(number); }});
  EXPECT_TRUE(result);
  EXPECT_EQ(numbers, (std::vector{1U, 2U}));
}

TEST_F(Call, DoesNotWaitWhereNothingNeedCome) {
  Client client = connect();
  const auto reply = checked(client.transact(msg::Control{}));
  EXPECT_EQ(reply->kind, ReplyKind::sent);
  EXPECT_TRUE(board.wait_for<msg::Control>(1));
}

TEST_F(Call, WaitsForAPossibleConfirmationIfAskedTo) {
  board.on<msg::BeepSound>([&](const msg::BeepSound& request) { board.confirm(request); });
  Client client = connect();
  const auto confirmed = checked(client.transact(
      msg::BeepSound{}, {.timeout = Ms(2000), .expect_confirmation = true, .validate = false}));
  EXPECT_EQ(confirmed->kind, ReplyKind::confirmed);
  board.ignore<msg::BeepSound>();
  const auto unconfirmed =
      checked(client.transact(msg::BeepSound{}, {.expect_confirmation = true, .validate = false}));
  EXPECT_EQ(unconfirmed->kind, ReplyKind::unconfirmed);
  // Also if the time for the call is over.
  for (const auto timeout : {std::optional<Ms>(), std::optional(Ms(200))}) {
    EXPECT_THAT(client.call(msg::BeepSound{},
                            {.timeout = timeout, .expect_confirmation = true, .validate = false}),
                fails(ErrorCode::unconfirmed));
  }
}

// Unsupported commands

TEST_F(Call, NeedsTheFirmwareBoardAndFeatureOfTheCommand) {
  EXPECT_THAT(connect_to_firmware(2439).beep_sound(),
              fails(ErrorCode::unsupported,
                    Eq("CMD_BEEP_SOUND needs firmware 2.59, the board has 2.43b9")));
  EXPECT_EQ(board.count<msg::BeepSound>(), 0U);
  Client old = connect_to_firmware(2590, 12);
  EXPECT_THAT(old.read_params_ext(),
              fails(ErrorCode::unsupported, "needs board 3.0, this is board 1.2"));
  EXPECT_FALSE(old.identity().details);
  EXPECT_THAT(connect_to_firmware(2700, 30).can_device_scan(),
              fails(ErrorCode::unsupported, Eq("CMD_CAN_DEVICE_SCAN needs BOARD_FEATURE_CAN_PORT, "
                                               "which this board does not report")));
}

TEST_F(Call, SendsTheLengthThatTheFirmwareExpects) {
  msg::EncodersCalibOffset4 request;
  {
    Client client = connect_to_firmware(2686);
    board.on<msg::EncodersCalibOffset4>(
        [&](const msg::EncodersCalibOffset4& arrived) { EXPECT_FALSE(arrived.for_motor); });
    EXPECT_TRUE(client.encoders_calib_offset_4(request));
    request.for_motor = msg::CalibMotor::roll;
    EXPECT_EQ(
        client.encoders_calib_offset_4(request).error().message,
        "CMD_ENCODERS_CALIB_OFFSET_4: for_motor: needs firmware 2.68b7, the board has 2.68b6");
    EXPECT_TRUE(board.wait_for<msg::EncodersCalibOffset4>(1)) << "before the line changes";
  }
  Client client = connect_to_firmware(2687);
  board.on<msg::EncodersCalibOffset4>([&](const msg::EncodersCalibOffset4& arrived) {
    EXPECT_EQ(arrived.for_motor, msg::CalibMotor::roll);
  });
  EXPECT_TRUE(client.encoders_calib_offset_4(request));
  EXPECT_TRUE(board.wait_for<msg::EncodersCalibOffset4>(2));
}

TEST_F(Call, RefusesValuesThatAreNotAllowedUnlessToldTo) {
  board.on<msg::EepromReadRequest>([&](const msg::EepromReadRequest& request) {
    board.send(msg::EepromRead{.addr = request.addr});
  });
  Client client = connect();
  EXPECT_THAT(client.eeprom_read({.addr = 7}),
              fails(ErrorCode::invalid, Eq("CMD_EEPROM_READ: addr: 7 is not a multiple of 64")));
  EXPECT_EQ(board.count<msg::EepromReadRequest>(), 0U);
  EXPECT_EQ(checked(client.eeprom_read({.addr = 7}, {.validate = false}))->addr, 7U);
}

TEST_F(Call, RefusesWhatCannotBeEncoded) {
  Client client = connect();
  // A stream of this message has to select its parts.
  EXPECT_THAT(client.data_stream_interval({.cmd_id = msg::CommandFromBoard::realtime_data_custom}),
              fails(ErrorCode::invalid, StartsWith("the request cannot be encoded")));
}

// Forms by firmware version

TEST_F(Call, TurnsMotorsOffWithABodyThatEveryFirmwareTakes) {
  board.on<msg::MotorsOff>([&](const msg::MotorsOff& request) { board.confirm(request); });
  for (const int firmware : {2430, 2590, 2686, 2687, 2740}) {
    SCOPED_TRACE(firmware);
    Client client = connect_to_firmware(static_cast<std::uint16_t>(firmware));
    const auto empty = board.count<msg::MotorsOff>();
    const auto result = client.motors_off();
    EXPECT_TRUE(result) << result.error().message;
    EXPECT_EQ(board.count<msg::MotorsOff>() - empty, 1U);
  }
}

TEST_F(Call, AnAttitudeHasTheFormThatTheFirmwareReads) {
  msg::AhrsHelper attitude;
  attitude.z1_vector = {0, 0, 1};
  board.answer<msg::AhrsHelperRequest>(attitude);
  board.answer<msg::AhrsHelperRequestWide>(attitude);
  std::promise<msg::AhrsHelperRequestExtWide> came;
  board.on<msg::AhrsHelperRequestExtWide>(
      [&](const msg::AhrsHelperRequestExtWide& request) { came.set_value(request); });
  msg::AhrsHelperRequestExt set;
  set.mode = msg::AhrsHelperModeBit::set | msg::AhrsHelperModeBit::reference_only;
  set.z1_vector = {0, 0, 1};
  set.h1_vector = {1, 0, 0};
  {
    Client client = connect_to_firmware(2694);
    EXPECT_EQ(*client.ahrs_helper(), attitude);
    EXPECT_TRUE(client.ahrs_helper_ext(set));
    EXPECT_TRUE(board.wait_for<msg::AhrsHelperRequestExt>(1));
    EXPECT_THAT(
        client.ahrs_helper_ext_wide(later_form(set)),
        fails(ErrorCode::unsupported,
              Eq("CMD_AHRS_HELPER in this form needs firmware 2.69b5, the board has 2.69b4")));
    EXPECT_EQ(board.count<msg::AhrsHelperRequestExtWide>(), 0U);
  }
  Client client = connect_to_firmware(2695);
  EXPECT_EQ(*client.ahrs_helper(), attitude);
  EXPECT_EQ(board.count<msg::AhrsHelperRequest>(), 1U);
  EXPECT_TRUE(client.ahrs_helper_ext(set));
  const msg::AhrsHelperRequestExtWide read = came.get_future().get();
  EXPECT_EQ(read.mode.raw(), 5);
  EXPECT_EQ(read.z1_vector, set.z1_vector);
  EXPECT_EQ(read.h1_vector, set.h1_vector);
  EXPECT_EQ(board.count<msg::AhrsHelperRequestExt>(), 1U);
}

// Errors of the board

TEST_F(Call, TellsTheReasonOfTheBoard) {
  msg::ErrorExt error{.cmd_id = msg::CommandToBoard::motors_on,
                      .error_code = msg::BoardErrorCode(12)};
  board.answer<msg::MotorsOn>(error);
  // The form without a command.
  board.answer<msg::CalibAcc>(msg::Error{.error_code = msg::BoardErrorCode::temporary});
  Client client = connect();
  EXPECT_EQ(client.motors_on().error(),
            (ClientError{ErrorCode::board_error,
                         "CMD_MOTORS_ON: the board refused: unknown code 12", 12}));
  error.error_code = msg::BoardErrorCode::wrong_state;
  board.answer<msg::MotorsOn>(error);
  EXPECT_EQ(
      client.motors_on().error(),
      (ClientError{ErrorCode::board_error, "CMD_MOTORS_ON: the board refused: WRONG_STATE", 8}));
  EXPECT_EQ(client.calib_acc().error().message, "CMD_CALIB_ACC: the board refused: TEMPORARY");
}

TEST_F(Call, TellsAnAnswerThatIsAnErrorByItsName) {
  msg::ReadFileError error{.err_code = msg::FileError::file_not_found};
  board.answer<msg::ReadFileRequest>(error);
  Client client = connect();
  const auto result = client.read_file();
  ASSERT_THAT(result, fails(ErrorCode::board_error));
  EXPECT_EQ(result.error().detail, static_cast<int>(msg::FileError::file_not_found));
  EXPECT_THAT(result.error().message, StartsWith("CMD_READ_FILE has failed: err_code "));
}

TEST_F(Call, FailsWhenTheConfirmationTellsOfAFailure) {
  board.on<msg::WriteFile>([&](const msg::WriteFile&) {
    msg::Confirm confirmation{.cmd = msg::WriteFile::command,
                              .err_code = msg::FileError::file_not_found};
    board.send(confirmation);
  });
  Client client = connect();
  const auto result = client.write_file();
  ASSERT_THAT(result, fails(ErrorCode::board_error));
  EXPECT_EQ(result.error().detail, static_cast<int>(msg::FileError::file_not_found));
}

// Lost messages

TEST_F(Call, EndsByItsDeadlineWhenTheBoardIsSilent) {
  Client client = connect();
  const auto begin = steady_clock::now();
  const auto result = client.get_angles({}, {.timeout = Ms(150)});
  const auto took = steady_clock::now() - begin;
  ASSERT_THAT(result, fails(ErrorCode::timeout));
  // The second message is reported if the client's thread stalls.
  EXPECT_THAT(result.error().message,
              AnyOf("no response to CMD_GET_ANGLES within 150 ms", "a handler blocks the client"));
  EXPECT_GE(took, Ms(150));
  EXPECT_LT(took, std::chrono::seconds(60));
}

TEST_F(Call, DoesNotTakeARepeatedAnswerForItsOwn) {
  // The repeated response arrives while the next request, sent immediately, waits for its own.
  board.on<msg::GetAnglesRequest>([&](const msg::GetAnglesRequest&) {
    msg::GetAngles answer;
    const auto before = static_cast<std::int16_t>(board.count<msg::GetAnglesRequest>());
    answer.axes.yaw.imu_angle = msg::Angle14(static_cast<std::int16_t>(before + 1));
    board.later(Ms(50), [this, answer] {
      board.send(answer);
      board.later(Ms(20), [this, answer] { board.send(answer); });
    });
  });
  ConnectOptions options = quick();
  options.duplicate_window = Ms(1000);
  Client client = connect(options);
  for (int i = 1; i <= 2; ++i) {
    const auto result =
        checked(client.get_angles({}, {.timeout = std::chrono::seconds(10), .retries = 0}));
    EXPECT_EQ(result->axes.yaw.imu_angle.raw(), i);
  }
}

// Broken and closed connections

TEST_F(Call, SaysWhatCameInsteadOfTheRequestedBlocks) {
  using Flag = msg::RealtimeDataCustomFlag;
  introduce(board, 2686, 36);
  board.on<msg::RealtimeDataCustomRequest>([&](const msg::RealtimeDataCustomRequest& request) {
    msg::RealtimeDataCustom data;
    data.imu_angles.emplace();
    if (request.flags.has(Flag::target_angles)) data.target_angles.emplace();
    board.send(data);
  });
  Client client = connect();
  const msg::RealtimeDataCustomRequest request{.flags = Flag::imu_angles | Flag::encoder_raw24};
  EXPECT_THAT(
      client.call(request),
      fails(
          ErrorCode::bad_response,
          Eq("the response CMD_REALTIME_DATA_CUSTOM cannot be decoded: 8 bytes, the flags need 17, "
             "and 8 without ENCODER_RAW24")));
  const auto reply = checked(client.transact(request));
  EXPECT_EQ(reply->body.size(), 8U);
  EXPECT_TRUE(client.call(msg::RealtimeDataCustomRequest{.flags = Flag::imu_angles}));
  EXPECT_EQ(board.count<msg::RealtimeDataCustomRequest>(), 3U) << "nothing is sent again";
  EXPECT_EQ(client.statistics().session.late_replies, 0U);
}

TEST_F(Call, FailsAtOnceWhenTheLineBreaks) {
  board.on<msg::GetAnglesRequest>([&](const msg::GetAnglesRequest&) { board.unplug(); });
  Client client = connect();
  const auto begin = steady_clock::now();
  const auto result = client.get_angles({}, {.timeout = std::chrono::seconds(120)});
  EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(60));
  EXPECT_THAT(result, fails(ErrorCode::link_lost, "CMD_GET_ANGLES: the connection is lost: "));
  EXPECT_THAT(client.get_angles(), fails(ErrorCode::not_connected));
}

TEST_F(Call, ThatRestartsTheBoardHasAnOptionalAnswer) {
  board.answer<msg::ResetRequestExt>(msg::Reset{});
  Client client = connect();
  const auto announced = checked(client.reset_ext({.confirm = msg::ResetOption::notify},
                                                  {.timeout = std::chrono::seconds(10)}));
  EXPECT_TRUE(announced->has_value());
  board.ignore<msg::ResetRequestExt>();
  const auto silent = checked(client.reset_ext());
  EXPECT_FALSE(silent->has_value());
}

TEST_F(Call, EndsWhenTheClientIsClosed) {
  Client client = connect();
  std::array<ErrorCode, 4> codes{};
  std::vector<std::thread> threads;
  threads.reserve(codes.size());
  for (ErrorCode& code : codes) {
    threads.emplace_back(
        [&] { code = client.calib_info({}, {.timeout = std::chrono::seconds(60)}).error().code; });
  }
  EXPECT_TRUE(board.wait_for<msg::CalibInfoRequest>(1));
  client.close();
  for (std::thread& thread : threads) thread.join();
  // Some calls may have started after close().
  EXPECT_THAT(codes, Each(AnyOf(ErrorCode::cancelled, ErrorCode::not_connected)));
  EXPECT_EQ(client.get_angles().error().code, ErrorCode::not_connected);
  client.close();
}

// Concurrent calls

TEST_F(Call, AThousandFromEightThreadsGetTheirOwnAnswers) {
  board.on<msg::EepromReadRequest>([&](const msg::EepromReadRequest& request) {
    msg::EepromRead answer{.addr = request.addr};
    for (unsigned i = 0; i < request.size.raw(); ++i) {
      answer.data.push_back(static_cast<std::uint8_t>(request.addr / 64 + i));
    }
    board.send(answer);
  });
  board.answer<msg::GetAnglesRequest>(msg::GetAngles{});
  Client client = connect();
  constexpr unsigned thread_count = 8;
  constexpr unsigned calls = 125;
  const CallOptions once{.timeout = std::chrono::seconds(60), .retries = 0};
  ASSERT_TRUE(client.get_angles({}, once));  // ends requests that connecting may have repeated
  const ClientStatistics before = client.statistics();
  std::array<unsigned, thread_count> good{};
  std::vector<std::thread> threads;
  threads.reserve(thread_count);
  for (unsigned t = 0; t < thread_count; ++t) {
    threads.emplace_back([&, t] {
      for (unsigned i = 0; i < calls; ++i) {
        if (i % 5 == 4) {
          good[t] += client.get_angles({}, once) ? 1U : 0U;
          continue;
        }
        const std::uint32_t address = 64 * (t * calls + i);
        const auto read = client.eeprom_read({.addr = address, .size = msg::ByteCount(64)}, once);
        if (!read || read->addr != address || read->data.size() != 64) continue;
        const auto expected = static_cast<std::uint8_t>(address / 64 + 63);
        good[t] += read->data[63] == expected ? 1U : 0U;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(good, Each(calls));
  const ClientStatistics statistics = client.statistics();
  EXPECT_EQ(statistics.failures, 0U);
  EXPECT_EQ(statistics.session.late_replies, before.session.late_replies);
}

TEST_F(Call, IsRefusedWhenTooManyWait) {
  // A call that waits for its response delays all others of its kind. None of them ends by itself,
  // so the limit is reached eventually, however slowly the threads start.
  ConnectOptions options = quick();
  options.queue_limit = 3;
  Client client = connect(options);
  std::promise<void> refused;
  std::once_flag once;
  std::vector<std::future<ErrorCode>> codes;
  codes.reserve(50);
  for (int i = 0; i < 50; ++i) {
    codes.push_back(std::async(std::launch::async, [&] {
      const auto result = client.calib_info({}, {.timeout = std::chrono::minutes(10)});
      const ErrorCode code = result.error().code;
      if (code == ErrorCode::overload) std::call_once(once, [&] { refused.set_value(); });
      return code;
    }));
  }
  const auto patience = std::chrono::seconds(60);
  EXPECT_EQ(refused.get_future().wait_for(patience), std::future_status::ready);
  client.close();
  for (auto& code : codes) {
    EXPECT_THAT(code.get(),
                AnyOf(ErrorCode::overload, ErrorCode::cancelled, ErrorCode::not_connected));
  }
}

TEST_F(Call, AStopSupersedesAllMotionThatIsQueued) {
  // More than the session holds.
  constexpr std::size_t motions = 300;
  ConnectOptions options = quick();
  options.pacing = true;
  Collector<int> received;  // speeds
  board.on<msg::Control>(
      [&](const msg::Control& request) { received.add(request.axes.yaw.speed.raw()); });
  Client client = connect(options);
  const auto turn = [](std::int16_t speed) {
    msg::Control request;
    request.control_mode.set_mode(msg::ControlModeKind::speed);
    request.axes.yaw.speed = msg::ControlSpeed(speed);
    std::array<std::uint8_t, msg::Control::max_size> body{};
    static_cast<void>(encode(request, std::span(body)));
    return *raw_request(static_cast<std::uint8_t>(msg::Control::command), body);
  };
  Collector<std::optional<ErrorCode>> ends;
  const auto begin = [&](std::int16_t speed) {
    client.start_raw(turn(speed), {}, [&](const Result<Reply>& reply) {
      ends.add(reply ? std::nullopt : std::optional(reply.error().code));
    });
  };
  for (std::size_t i = 0; i < motions; ++i) begin(100);
  begin(0);
  const auto codes = ends.wait_for(motions + 1);
  const auto superseded = std::ranges::count(codes, std::optional(ErrorCode::superseded));
  EXPECT_GT(superseded, 0);
  const std::size_t sent = motions + 1 - static_cast<std::size_t>(superseded);
  EXPECT_EQ(received.wait_for(sent).back(), 0) << "nothing follows the stop";
}

TEST(Errors, PrintTheirMessage) {
  std::ostringstream text;
  text << ClientError{ErrorCode::timeout, "no answer"} << '|' << ErrorCode::link_lost << '|'
       << io::Error{io::Errc::busy, "ttyUSB0 is in use."};
  EXPECT_EQ(text.str(), "no answer|link_lost|ttyUSB0 is in use.");
}

// Handlers

TEST_F(Call, FromAHandlerIsRefused) {
  Client client = connect();
  std::promise<ErrorCode> code;
  const auto subscription = client.subscribe<msg::GetAngles>(
      [&](const msg::GetAngles&) { code.set_value(client.get_angles().error().code); });
  board.send(msg::GetAngles{});
  EXPECT_EQ(code.get_future().get(), ErrorCode::invalid);
}

TEST_F(Call, EndsByItsDeadlineAlsoWhenAHandlerKeepsTheClientBusy) {
  Client client = connect();
  std::promise<void> entered;
  std::promise<void> leave;
  const auto subscription = client.subscribe<msg::GetAngles>([&](const msg::GetAngles&) {
    entered.set_value();
    leave.get_future().wait();
  });
  board.send(msg::GetAngles{});
  entered.get_future().wait();
  EXPECT_THAT(client.calib_info({}, {.timeout = Ms(50)}), fails(ErrorCode::timeout));
  leave.set_value();
}

}  // namespace
}  // namespace sbgc::test
