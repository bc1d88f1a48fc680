// The board's default responses match the model: for every request, including those with their own
// handlers, because later commands have none.

#include "device/default_response.hpp"

#include <sbgc/dispatch.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/roles.hpp>

#include "device/device.hpp"
#include "host.hpp"

namespace sbgc::test {
namespace {

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

}  // namespace
}  // namespace sbgc::test
