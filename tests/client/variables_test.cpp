#include <cmath>

#include <sbgc/availability.hpp>
#include <sbgc/client/variables.hpp>
#include <sbgc/meta/enums.hpp>

#include "task_test.hpp"

namespace sbgc::test {
namespace {

class VariablesTest : public TaskTest {
 protected:
  void set(msg::VariableId id, std::int32_t value) {
    msg::SetAdjVarsVal request;
    request.params.push_back({id, value});
    board.write(request);
  }
  std::int32_t get(msg::VariableId id) {
    msg::GetAdjVarsVal request;
    request.param_id.push_back(id);
    return board.read<msg::SetAdjVarsVal>(request).params[0].param_value;
  }
};

TEST_F(VariablesTest, AreReadInTheirUnits) {
  set(msg::VariableId::lpf_freq_roll, 120);
  set(msg::VariableId::i_yaw, 5);
  set(msg::VariableId::frame_heading_angle, -1234);
  set(msg::VariableId::pid_gain_pitch, 45);
  const std::vector<std::string> names{"LPF_FREQ_ROLL", "I_YAW", "FRAME_HEADING_ANGLE",
                                       "PID_GAIN_PITCH"};
  const auto values = checked(client().get_variables(names));
  ASSERT_THAT(*values, SizeIs(4));
  EXPECT_DOUBLE_EQ(values->at(0), 120);
  EXPECT_DOUBLE_EQ(values->at(1), 0.05);
  EXPECT_DOUBLE_EQ(values->at(2), -123.4);
  EXPECT_DOUBLE_EQ(values->at(3), 1.0);
  EXPECT_EQ(board.log().size(), 1U);
}

TEST_F(VariablesTest, AreSetInTheirUnitsAndRounded) {
  const std::vector<VariableValue> values{
      {"FRAME_HEADING_ANGLE", -180}, {"I_ROLL", 0.126}, {"GYRO_HEADING_CORRECTION", 20}};
  ASSERT_TRUE(client().set_variables(values));
  EXPECT_EQ(get(msg::VariableId::frame_heading_angle), -1800);
  EXPECT_EQ(get(msg::VariableId::i_roll), 13);
  EXPECT_EQ(count<msg::SetAdjVarsVal>(), 1U);
}

TEST_F(VariablesTest, UnknownNamesAreRefusedWithAHint) {
  EXPECT_EQ(client().get_variable("P_PICTH").error().code, ErrorCode::not_found);
  EXPECT_THAT(client().get_variable("p_pitch").error().message, HasSubstr("P_PITCH"));
  EXPECT_THAT(client().set_variable("LPF_ROLL", 1).error().message, HasSubstr("LPF_FREQ_ROLL"));
  EXPECT_EQ(board.log().size(), 0U);
}

TEST_F(VariablesTest, ValuesOutOfRangeAreRefusedBeforeAnythingIsSent) {
  const std::vector<VariableValue> values{{"P_ROLL", 10}, {"LPF_FREQ_YAW", 401}};
  const auto error = client().set_variables(values).error();
  EXPECT_EQ(error.code, ErrorCode::invalid);
  EXPECT_EQ(error.message, "LPF_FREQ_YAW: 401 Hz is above 400 Hz");
  EXPECT_FALSE(client().set_variable("P_ROLL", std::nan("")));
  EXPECT_FALSE(client().set_variable("P_ROLL", std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(client().set_variable("P_ROLL", -1));
  EXPECT_EQ(board.log().size(), 0U);
}

TEST_F(VariablesTest, EveryLimitOfEveryVariableCanBeSetAndNothingBeyond) {
  for (const VariableInfo& variable : variables) {
    for (const double raw : {variable.range.lowest, variable.range.highest}) {
      const double value = variable_value(variable, static_cast<std::int32_t>(raw));
      const auto back = variable_raw(variable, value);
      ASSERT_TRUE(back) << variable.name;
      EXPECT_EQ(*back, raw) << variable.name;
    }
    const auto beyond = static_cast<std::int32_t>(variable.range.highest) + 1;
    EXPECT_FALSE(variable_raw(variable, variable_value(variable, beyond))) << variable.name;
  }
}

TEST_F(VariablesTest, TheUnitIsThatOfTheFirmware) {
  const VariableInfo& p = **find_variable("P_ROLL");
  constexpr Availability later{.firmware = 2745, .board = 36};
  EXPECT_EQ(variable_value(p, 70), 70);
  EXPECT_NEAR(variable_value(p, 70, later), 9.7921, 1e-4);
  EXPECT_EQ(*variable_raw(p, 9.8, later), 70);
  EXPECT_EQ(*variable_raw(p, 255, later), 255);
  EXPECT_FALSE(variable_raw(p, 300, later));
  EXPECT_FALSE(variable_raw(p, -1, later));
}

TEST_F(VariablesTest, ManyAreMovedInMessagesOfForty) {
  std::vector<std::string> names;
  std::vector<VariableValue> values;
  for (const VariableInfo& variable : variables) {
    const auto known = std::ranges::find(EnumMeta<msg::VariableId>::values,
                                         static_cast<std::int64_t>(variable.id), &ValueInfo::value);
    if (!is_available(known->since, client().identity().versions())) continue;
    names.emplace_back(variable.name);
    values.push_back({variable.name,
                      variable_value(variable, static_cast<std::int32_t>(variable.range.highest))});
  }
  ASSERT_GT(names.size(), 40U);
  ASSERT_TRUE(client().set_variables(values));
  EXPECT_EQ(count<msg::SetAdjVarsVal>(), 2U);
  EXPECT_EQ(board.log()[0].body[0], 40);
  const auto read = checked(client().get_variables(names));
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(read->at(i), values[i].value);

  connect(few_retries);
  board.on_lost([](const Packet& request) {
    return is<msg::SetAdjVarsVal>(request) && request.body[0] != 40;
  });
  EXPECT_THAT(client().set_variables(values).error().message, HasSubstr("after 40 of"));
}

TEST_F(VariablesTest, AnswersAboutOtherVariablesAreNotTaken) {
  board.tamper([](Packets& answers) {
    if (answers.empty() || !is<msg::SetAdjVarsVal>(answers[0])) return;
    answers[0].body[6] = static_cast<std::uint8_t>(msg::VariableId::d_yaw);  // of the second one
  });
  EXPECT_EQ(client().get_variables({"P_ROLL", "P_PITCH"}).error().code, ErrorCode::mismatch);
  board.tamper([](Packets& answers) {
    if (answers.empty() || !is<msg::SetAdjVarsVal>(answers[0])) return;
    answers[0].body = {0};
  });
  EXPECT_EQ(client().get_variable("P_ROLL").error().code, ErrorCode::mismatch);
}

TEST_F(VariablesTest, AreSaved) {
  set(msg::VariableId::i_roll, 33);
  ASSERT_NE(board.settings<msg::ReadParams3>(1).axes.roll.i.raw(), 33);
  ASSERT_TRUE(client().save_variables());
  EXPECT_EQ(count<msg::SaveParams3>(), 1U);
  disconnect();
  board.become(board.options());  // power cycle
  EXPECT_EQ(get(msg::VariableId::i_roll), 33);
}

TEST_F(VariablesTest, ABoardThatRefusesToSaveIsReported) {
  static_cast<void>(client());
  board.tamper([](Packets& answers) {
    msg::ErrorExt error{.cmd_id = msg::CommandToBoard::save_params_3,
                        .error_code = msg::BoardErrorCode::wrong_state};
    answers = {packet(error)};
  });
  EXPECT_EQ(client().save_variables().error().code, ErrorCode::board_error);
}

}  // namespace
}  // namespace sbgc::test
