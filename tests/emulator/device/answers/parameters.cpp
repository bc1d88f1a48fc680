// Checks of parameters and adjustable variables.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <gmock/gmock.h>

#include <sbgc/parameters.hpp>
#include <sbgc/type_list.hpp>

#include "table.hpp"

namespace sbgc::test {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

}  // namespace

void Table::add_parameters() {
  // Every request that reads or writes a message with parameters, for the last copy: all bits that
  // are settings are inverted, written and read back.
  ParameterMessages::for_each([this]<class M>(Type<M>) {
    using Parameters = ParametersOf<M>;
    constexpr std::uint8_t copy = Parameters::copies - 1;
    const auto read = [](Host& host) {
      M result{};
      Parameters::Readers::for_each([&]<class Request>(Type<Request>) {
        Request request{};
        if constexpr (Parameters::copies > 1) Parameters::copy(request) = copy;
        result = host.get<typename Request::Response>(request);
      });
      return result;
    };
    Parameters::Readers::for_each([&]<class Request>(Type<Request>) {
      Request request{};
      if constexpr (Parameters::copies > 1) Parameters::copy(request) = copy;
      add<Request>({.request = request, .after = [](Host&, const Packets& packets) {
                      const auto parameters = only<typename Request::Response>(packets);
                      if constexpr (Parameters::copies > 1) {
                        EXPECT_EQ(Parameters::copy(parameters), Parameters::copies - 1);
                      }
                    }});
    });
    Parameters::Writers::for_each([&]<class Request>(Type<Request>) {
      M wanted{};
      std::array<std::uint8_t, max_body_size> body{};
      for (std::size_t i = 0; i < M::min_size; ++i) body[i] = static_cast<std::uint8_t>(i * 37 + 5);
      ASSERT_TRUE(decode(std::span(body).first(M::min_size), wanted));
      if constexpr (Parameters::copies > 1) Parameters::copy(wanted) = copy;
      add<Request>({.request = Request{wanted},
                    .comes = Comes::confirmation,
                    .after = [wanted, read](Host& host, const Packets&) mutable {
                      M found = read(host);
                      Meta<M>::visit(found, [&](const FieldInfo& field, auto&& member) {
                        if (field.role != FieldRole::state) return;
                        Meta<M>::visit(wanted, [&](const FieldInfo& other, auto&& value) {
                          if constexpr (std::is_same_v<decltype(member), decltype(value)>) {
                            if (&other == &field) value = member;
                          }
                        });
                      });
                      EXPECT_EQ(found, wanted);
                    }});
    });
  });
  add<msg::SaveParams3>(
      {.comes = Comes::confirmation,
       .before =
           [](Host& host) {
             msg::SetAdjVarsVal change;
             change.params.push_back({msg::VariableId::p_roll, 77});
             host.ask(change);
           },
       .after =
           [](Host& host, const Packets&) {
             host.board.restart(host.now);
             host.listen(seconds(2));
             EXPECT_EQ(host.get<msg::ReadParams3>(msg::ReadParams3Request{}).axes.roll.p, 77);
           }});
  add<msg::UseDefaults>({.comes = Comes::confirmation,
                         .before =
                             [](Host& host) {
                               auto parameters =
                                   host.get<msg::ReadParams3>(msg::ReadParams3Request{});
                               parameters.gyro_trust =
                                   static_cast<std::uint8_t>(parameters.gyro_trust + 1);
                               host.ask(msg::WriteParams3{parameters});
                             },
                         .after =
                             [](Host& host, const Packets&) {
                               Host fresh;
                               EXPECT_EQ(host.get<msg::ReadParams3>(msg::ReadParams3Request{}),
                                         fresh.get<msg::ReadParams3>(msg::ReadParams3Request{}));
                             }});
}

void Table::add_variables() {
  msg::SetAdjVarsVal set;
  set.params.push_back({msg::VariableId::p_roll, 42});
  set.params.push_back({msg::VariableId::rc_trim_yaw, -5});
  msg::GetAdjVarsVal get;
  get.param_id.push_back(msg::VariableId::rc_trim_yaw);
  get.param_id.push_back(msg::VariableId::p_roll);
  const auto are_set = [](Host&, const Packets& packets) {
    const auto values = all<msg::SetAdjVarsVal>(packets);
    ASSERT_THAT(values, SizeIs(1));
    EXPECT_THAT(values[0].params, ElementsAre(msg::AdjVarValue{msg::VariableId::rc_trim_yaw, -5},
                                              msg::AdjVarValue{msg::VariableId::p_roll, 42}));
  };
  add<msg::SetAdjVarsVal>(
      {.request = set, .after = [=](Host& host, const Packets&) {
         are_set(host, host.ask(get));
         EXPECT_EQ(host.get<msg::ReadParams3>(msg::ReadParams3Request{}).axes.roll.p, 42);
       }});
  add<msg::GetAdjVarsVal>(
      {.request = get, .before = [=](Host& host) { host.ask(set); }, .after = are_set});
  add<msg::AdjVarsStateRequest>({.request = {.trigger_slot = 9, .analog_slot = 14}});
  emulator::BoardOptions later;
  later.firmware = msg::FirmwareVersion(msg::AdjVarsStateRequestExt::since.firmware);
  add<msg::AdjVarsStateRequestExt>({.options = later});
}

}  // namespace sbgc::test
