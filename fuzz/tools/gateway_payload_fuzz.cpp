// Fuzzes what a broker delivers to a gateway: a topic, a line break, and a payload.
//
// Invariants: every refusal has a sentence as its reason; a result is only sent below the reply
// topic; an accepted order has only permitted effects.

#include <variant>

#include "gateway/orders.hpp"
#include "gateway/payload.hpp"
#include "input.hpp"
#include "values/message_names.hpp"

namespace {

using namespace sbgc::tools;  // NOLINT(google-build-using-namespace): a fuzzer of them
using sbgc::fuzz::require;

void check(const Order& order, sbgc::Effects allowed) {
  const auto* const call = std::get_if<CallOrder>(&order.what);
  if (call == nullptr) return;
  const sbgc::Effects effects = effects_of(call->request);
  for (const auto effect : {sbgc::Effect::moves, sbgc::Effect::restarts, sbgc::Effect::unknown}) {
    require(!effects.has(effect) || order.must_not_wait);
  }
  for (const auto effect : {sbgc::Effect::stores, sbgc::Effect::moves, sbgc::Effect::restarts,
                            sbgc::Effect::erases, sbgc::Effect::unknown}) {
    require(!effects.has(effect) || allowed.has(effect));
  }
  require(!call->request.holds_secret());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Topics topics("f");
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the interface of libFuzzer
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = input.find('\n');
  const std::string_view topic = input.substr(0, end);
  const std::string_view text = end == std::string_view::npos ? "" : input.substr(end + 1);
  CommandPayload payload;
  require(!is_key(text) || is_utf8(text));
  try {
    const auto command = topics.command(topic);
    if (command && command->task == "stop") {
      CommandPayload stop;
      for (const std::string& what : read_stop_payload(text, topics, stop)) require(!what.empty());
      require(stop.reply.empty() || topics.is_reply(stop.reply));
    }
    read_payload(text, topics, payload);
    require(payload.key.size() <= longest_key);
    if (!command) return 0;
    // Tasks of their own have the effects that they need.
    const sbgc::Effects raw = sbgc::Effect::sets;
    const Order order = read_order(command->task, payload.parameters, raw);
    if (command->task == "raw") check(order, raw);
  } catch (const Refusal& refusal) {
    require(*refusal.what() != '\0' && *refusal.code() != '\0');
  }
  require(payload.reply.empty() || payload.reply.starts_with("sbgc/f/reply/"));
  return 0;
}
