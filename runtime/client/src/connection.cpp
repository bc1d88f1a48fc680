#include "connection.hpp"

#include <optional>
#include <utility>

#include "conversation/state.hpp"
#include "driving/task_driver.hpp"

namespace sbgc::detail {

namespace {

Stop canceller(const Conversation& conversation, CallId id) {
  return [conversation, id] { conversation.cancel(id); };
}

}  // namespace

Connection::Connection(std::shared_ptr<const void> keeper, asio::any_io_executor executor,
                       Conversation conversation)
    : keeper_(std::move(keeper)),
      executor_(std::move(executor)),
      conversation_(std::move(conversation)) {}

Connection::~Connection() { close(); }

Result<Reply> Connection::call(const Prepare& prepare, const CallOptions& options) {
  return conversation_.call(prepare(conversation_), options);
}

Stop Connection::start(const Prepare& prepare, const CallOptions& options,
                       const Completion<Result<Reply>>& done) {
  return canceller(conversation_, conversation_.start(prepare(conversation_), options, done));
}

Result<Subscription> Connection::stream(const Stream& stream, const CallOptions& options) {
  return conversation_.stream(stream.prepare(conversation_), stream.key, stream.handler, options);
}

Stop Connection::start_stream(const Stream& stream, const CallOptions& options,
                              const Completion<Result<Subscription>>& done) {
  return canceller(conversation_,
                   conversation_.start_stream(stream.prepare(conversation_), stream.key,
                                              stream.handler, options, done));
}

std::optional<ClientError> Connection::run(const BeginTask& begin, Clock& clock) {
  drive(conversation_, begin(conversation_.identity()), clock);
  return std::nullopt;
}

Stop Connection::start_task(const BeginTask& begin,
                            const Completion<std::optional<ClientError>>& done) {
  return tasks_.run(executor_, conversation_, begin(conversation_.identity()),
                    [done] { done(std::nullopt); });
}

Subscription Connection::subscribe(MessageKey key, MessageHandler handler) {
  return conversation_.subscribe(key, std::move(handler));
}

Subscription Connection::on_frame(std::function<void(const BoardFrame&)> handler) {
  return conversation_.on_frame(std::move(handler));
}

Subscription Connection::on_notice(std::function<void(const Notice&)> handler) {
  return conversation_.on_notice(std::move(handler));
}

Subscription Connection::on_change(std::function<void(const LinkChange&)> handler) {
  return on_notice([handler = std::move(handler)](const Notice& notice) {
    if (notice.kind == NoticeKind::link_lost) handler({LinkState::lost, notice.message, {}});
  });
}

LinkState Connection::state() const {
  const auto ended = conversation_.state()->end_reason();
  if (!ended) return LinkState::connected;
  return ended->code == ErrorCode::link_lost ? LinkState::lost : LinkState::closed;
}

void Connection::close() noexcept {
  conversation_.close();
  tasks_.cancel_all();
}

}  // namespace sbgc::detail
