// For every request of the model, the emulated board's response matches the model, and so does its
// default response: it is tested for requests with their own handlers, too, because later commands
// have none. Requests whose values matter have rows in conversations/modelled.txt. A request
// without a row needs no more than the model says.

#include "answers.hpp"

#include <fstream>
#include <type_traits>

#include <sbgc/client/request.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/message_infos.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/roles.hpp>

#include "device/default_response.hpp"
#include "device/device.hpp"

namespace sbgc::test {
namespace {

void expect_responses(const ResponsePolicy& policy, const Packets& packets, Comes comes) {
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
          << "the model leaves it open: say in conversations/modelled.txt what the emulated board "
             "does";
      EXPECT_EQ(confirmations, comes == Comes::confirmation ? policy.confirmations : 0U);
      break;
  }
}

Duration patience(const ResponsePolicy& policy) {
  // How long a series takes depends on the request: the one here is over sooner.
  if (policy.series != 0) return seconds(10);
  return milliseconds(std::max(policy.timeout_ms, policy.finish_ms));
}

}  // namespace

void expect_as_modelled(Host& host, const ResponsePolicy& policy,
                        std::span<const std::uint8_t> frame, Comes comes) {
  const std::uint64_t restarts = host.board.counters().restarts;
  host.send_bytes(frame);
  expect_responses(policy, host.listen(patience(policy)), comes);
  if (policy.restarts_board) host.listen(seconds(2));
  EXPECT_EQ(host.board.counters().restarts - restarts, policy.restarts_board ? 1U : 0U);
}

void expect_as_modelled(Host& host, const AnyMessage& request, Comes comes) {
  SCOPED_TRACE(request.type().info->name);
  std::array<std::uint8_t, max_frame_size> frame{};
  const std::size_t size = request.encode_frame(host.framing, frame).size;
  expect_as_modelled(host, detail::policy_of(request), std::span(frame).first(size), comes);
}

namespace {

template <Message M>
void check(Host& host, const M& request, Comes comes = Comes::as_modelled) {
  expect_as_modelled(host, AnyMessage(detail::message_type<M>(), &request), comes);
}

/// A new board that has the request.
Host host_for(const MessageInfo& request) {
  const emulator::BoardOptions usual;
  const Availability versions{usual.firmware.raw(), usual.board.raw()};
  return Host(is_supported(request, versions) ? usual : newest_board());
}

// The last copy: all bits that are settings are inverted, written and read back.
TEST(Answers, ParametersComeBack) {
  ParameterMessages::for_each([]<class M>(Type<M>) {
    using Parameters = ParametersOf<M>;
    constexpr std::uint8_t copy = Parameters::copies - 1;
    const auto read = [](Host& host) {
      M result{};
      Parameters::Readers::for_each([&]<class Request>(Type<Request>) {
        Request request{};
        if constexpr (Parameters::copies > 1) Parameters::copy(request) = copy;
        result = host.get<typename Request::Response>(request);
        if constexpr (Parameters::copies > 1)
          EXPECT_EQ(Parameters::copy(result), Parameters::copies - 1);
      });
      return result;
    };
    Parameters::Readers::for_each([&]<class Request>(Type<Request>) {
      Host host = host_for(Meta<Request>::info);
      Request request{};
      if constexpr (Parameters::copies > 1) Parameters::copy(request) = copy;
      check(host, request);
    });
    Parameters::Writers::for_each([&]<class Request>(Type<Request>) {
      Host host = host_for(Meta<Request>::info);
      M wanted{};
      std::array<std::uint8_t, max_body_size> body{};
      for (std::size_t i = 0; i < M::min_size; ++i) body[i] = static_cast<std::uint8_t>(i * 37 + 5);
      ASSERT_TRUE(decode(std::span(body).first(M::min_size), wanted));
      if constexpr (Parameters::copies > 1) Parameters::copy(wanted) = copy;
      check(host, Request{wanted}, Comes::confirmation);
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
    });
  });
}

/// The names of the requests that have a row, or are of parameters.
std::set<std::string> checked_elsewhere() {
  std::set<std::string> names;
  std::ifstream file(SBGC_CONVERSATIONS "/modelled.txt");
  for (std::string word; file >> word;) names.insert(word);
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    const auto add = [&]<class Request>(Type<Request>) { names.insert(Meta<Request>::info.name); };
    ParametersOf<M>::Readers::for_each(add);
    ParametersOf<M>::Writers::for_each(add);
  });
  return names;
}

TEST(Answers, AreWhatTheModelSays) {
  const std::set<std::string> elsewhere = checked_elsewhere();
  for (const MessageType* const type : message_types()) {
    if (!type->is_sent_to_board() || elsewhere.contains(type->info->name)) continue;
    Host host = host_for(*type->info);
    // Requests whose effect no source describes have no response.
    const bool is_documented = !type->info->effects.has(Effect::unknown);
    expect_as_modelled(host, any_request(*type),
                       is_documented ? Comes::as_modelled : Comes::nothing);
  }
}

using emulator::default_response;
using emulator::Device;
using emulator::Reaction;
using emulator::RequestContext;

template <class Request>
void expect_answer_of_model(const Request& request) {
  SCOPED_TRACE(Meta<Request>::info.name);
  Device device(newest_board(), {}, {});
  const auto port = device.ports.open(false).value();
  const ResponsePolicy policy = response_policy(request);
  RequestContext context(device.ports, device.options, port, policy.responses.command,
                         policy.responses.confirmed, {});
  EXPECT_EQ(default_response(context, request), Reaction::executed);

  unsigned answers = 0, confirmations = 0;
  Parser parser;
  parser.feed(device.ports.output(port), [&](const Frame& frame) {
    if (const ResponseForm* const form = policy.responses.form_of(frame)) {
      ++answers;
      EXPECT_FALSE(form->is_error);
      const Code form_of_answer =
          select(Direction::from_board, frame.id, frame.body.size(), [](auto) {});
      EXPECT_EQ(form_of_answer, Code::ok);
    } else {
      ++confirmations;
      ASSERT_TRUE(roles::is_confirmation(frame));
      EXPECT_TRUE(policy.responses.is_confirmed_by(roles::confirmed_command(frame), frame));
      EXPECT_FALSE(policy.result.is_failure(frame.body));
    }
  });
  EXPECT_EQ(parser.counters().skipped_bytes, 0U);
  if (!emulator::is_documented<Request>) {
    EXPECT_EQ(answers + confirmations, 0U);
    return;
  }
  EXPECT_EQ(answers, policy.response_required ? 1U : 0U);
  const bool confirms = policy.responses.confirmed == Confirmed::always ||
                        policy.responses.confirmed == Confirmed::possible;
  EXPECT_EQ(confirmations, confirms ? policy.confirmations : 0U);
}

TEST(DefaultAnswer, FitsTheModelForEveryRequest) {
  AllMessages::for_each([]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) expect_answer_of_model(M{});
  });
}

TEST(DefaultAnswer, RepeatsWhatTheRequestHas) {
  expect_answer_of_model(msg::EepromReadRequest{.addr = 0x12345640, .size = msg::ByteCount(64)});
  expect_answer_of_model(msg::EepromWrite{.addr = 0x12345640, .data = {}});
  expect_answer_of_model(msg::ReadParams3Request{.profile_id = 4});
  msg::ReadFileRequest file;
  file.page_offset = msg::Pages(7);
  expect_answer_of_model(file);
}

TEST(DefaultAnswer, HasRoomForBlocksThatTheRequestAsksFor) {
  expect_answer_of_model(
      msg::RealtimeDataCustomRequest{.flags = msg::RealtimeDataCustomFlags(0x1FF)});
}

TEST(DefaultAnswer, DependsOnTheRequest) {
  msg::ResetRequestExt request;
  expect_answer_of_model(request);
  request.confirm = msg::ResetOption::notify;
  expect_answer_of_model(request);
  // A request whose confirmation is unlikely is not confirmed.
  expect_answer_of_model(msg::AhrsHelperRequestExt{.mode = msg::AhrsHelperModeBit::set});
}

TEST(Menu, HasAllActionsOfTheModelAndNoOther) {
  for (int action = 0; action < 256; ++action) {
    bool is_known = false;
    for (const ValueInfo& info : EnumMeta<msg::MenuCommand>::values)
      is_known |= info.value == action;
    Host host;
    const auto packets = host.ask(msg::ExecuteMenu{static_cast<msg::MenuCommand>(action)});
    EXPECT_EQ(all<msg::Confirm>(packets).size(), is_known ? 1U : 0U) << action;
    EXPECT_EQ(all<msg::ErrorExt>(packets).size(), is_known ? 0U : 1U) << action;
  }
}

}  // namespace
}  // namespace sbgc::test
