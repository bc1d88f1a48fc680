#include <optional>
#include <string>
#include <utility>

#include <sbgc/availability.hpp>
#include <sbgc/client/passive_client.hpp>
#include <sbgc/roles.hpp>

#include "passive_state.hpp"

namespace sbgc {

namespace {

Task<Result<roles::Introduction>> introduce(std::optional<std::string> password) {
  if (!password) co_return co_await tasks::call(roles::IntroductionRequest{});
  const auto request = detail::opening_request(*password);
  if (!request) co_return request.error();
  co_return co_await tasks::call(*request);
}

using Details = detail::CallResponse<roles::DetailsRequest>;

Task<Result<Details>> ask_details() { co_return co_await tasks::call(roles::DetailsRequest{}); }

}  // namespace

PassiveClient::PassiveClient(const ConnectOptions& options, bool line_may_repeat)
    : state_(std::make_unique<State>(options, line_may_repeat)) {}

PassiveClient::~PassiveClient() = default;

void PassiveClient::connect(std::function<void(const Result<void>&)> done) {
  start(introduce(state_->options().password), [this, done = std::move(done)](auto info) mutable {
    if (!info) return done(std::move(info).error());
    set_identity({.info = *std::move(info)});
    state_->change_framing([this, done = std::move(done)] {
      if (!is_supported<roles::DetailsRequest>(identity().versions())) return done({});
      start(ask_details(), [this, done](auto details) {
        if (!details) return done(std::move(details).error());
        state_->identity().details = *std::move(details);
        done({});
      });
    });
  });
}

void PassiveClient::detect_line(SetLine set_line, std::function<void(const Result<void>&)> done) {
  state_->detect_line(std::move(set_line), std::move(done));
}

void PassiveClient::set_line(const LineSettings& line) { state_->set_line(line); }

const BoardIdentity& PassiveClient::identity() const noexcept { return state_->identity(); }

SessionStatistics PassiveClient::statistics() const noexcept { return state_->statistics(); }

void PassiveClient::set_identity(const BoardIdentity& board) { state_->identity() = board; }

TaskMachine& PassiveClient::start(TaskMachine& task, std::function<void()> finish) {
  return state_->start(task, std::move(finish));
}

Subscription PassiveClient::subscribe(detail::MessageKey key, detail::MessageHandler handler) {
  return Subscription(state_->delivery().subscribe(key, std::move(handler)));
}

Subscription PassiveClient::on_notice(std::function<void(const Notice&)> handler) {
  return Subscription(state_->delivery().on_notice(std::move(handler)));
}

Subscription PassiveClient::on_frame(std::function<void(const BoardFrame&)> handler) {
  return Subscription(state_->delivery().on_frame(std::move(handler)));
}

void PassiveClient::receive(std::span<const std::uint8_t> bytes, Instant now) {
  state_->receive(bytes, now);
}

std::span<const std::uint8_t> PassiveClient::advance(Instant now) { return state_->advance(now); }

void PassiveClient::written(Instant now) { state_->written(now); }

Instant PassiveClient::deadline() const noexcept { return state_->deadline(); }

// The state

void PassiveClient::State::detect_line(SetLine set_line,
                                       std::function<void(const Result<void>&)> done) {
  auto question = detail::opening_frame(options_.password);
  // It keeps a view of the question, whose bytes do not move when the vector is moved.
  Detector detector({.question = question});
  search_ = std::make_unique<Search>(
      Search{std::move(question), detector, std::move(set_line), std::move(done)});
  has_news_ = true;
}

std::span<const std::uint8_t> PassiveClient::State::search() {
  Detector& detector = search_->detector;
  while (true) {
    const DetectorStep step = detector.next(now_);
    switch (step.kind) {
      case DetectorStep::Kind::set_line:
        if (!search_->set_line(step.line)) detector.refuse();
        break;
      case DetectorStep::Kind::write: is_writing_ = true; return step.bytes;
      case DetectorStep::Kind::wait: deadline_ = step.until; return {};
      case DetectorStep::Kind::found:
        dialogue_.set_line(step.line);
        end_search({});
        return {};
      case DetectorStep::Kind::failed:
        end_search(ClientError{ErrorCode::not_found, "no board answers at any baud rate"});
        return {};
    }
  }
}

void PassiveClient::State::end_search(const Result<void>& result) {
  has_news_ = true;
  std::exchange(search_, nullptr)->done(result);
}

void PassiveClient::State::change_framing(const std::function<void()>& done) {
  const Framing newest = newest_framing(identity_.versions());
  if (!options_.newest_framing || newest == basic_framing) return done();
  auto request = detail::prepare(roles::IntroductionRequest{}, identity_.versions(), true);
  if (!request) return done();
  request->tried_framing = newest;
  const auto tried = [this, done](const Result<Reply>&) {
    has_news_ = true;
    done();
  };
  const detail::CallPointer call =
      detail::make_call(detail::next_call_id(), *std::move(request), {}, options_, now_, tried);
  if (calls_.begin(call)) done();
}

TaskMachine& PassiveClient::State::start(TaskMachine& task, std::function<void()> finish) {
  task.set_number(calls_->order().begin());
  task.set_repeating_line(line_may_repeat_);
  const auto running = std::make_shared<Running>();
  running->machine = &task;
  running->finish = std::move(finish);
  running->notices = delivery_.on_notice([&task](const Notice& one) { task.notice(one); });
  running->strays = delivery_.on_frame([&task](const BoardFrame& one) {
    if (!one.belongs_to_call) task.overheard(one.frame.id, one.frame.body);
  });
  running_.push_back(running);
  has_news_ = true;
  return task;
}

void PassiveClient::State::receive(std::span<const std::uint8_t> bytes, Instant now) {
  now_ = later(now_, now);
  if (bytes.empty()) return;
  has_news_ = true;
  if (search_) return search_->detector.feed(bytes);
  dialogue_.feed(bytes, now);
}

std::span<const std::uint8_t> PassiveClient::State::advance(Instant now) {
  now_ = later(now_, now);
  has_news_ = false;
  if (search_) return is_writing_ ? std::span<const std::uint8_t>{} : search();
  Instant next = Instant::never;
  const auto tasks = running_;  // a task that ends may start another one
  for (const auto& running : tasks) next = earlier(next, step(*running));
  std::erase_if(running_, [](const auto& one) { return one->is_over; });
  const Output output = dialogue_.advance(now, !is_writing_);
  is_writing_ = is_writing_ || !output.bytes.empty();
  deadline_ = earlier(next, output.deadline);
  return output.bytes;
}

void PassiveClient::State::written(Instant now) {
  now_ = later(now_, now);
  if (!std::exchange(is_writing_, false)) return;
  if (!search_) dialogue_.written(now);
  has_news_ = true;
}

Instant PassiveClient::State::step(Running& running) {
  TaskMachine& task = *running.machine;
  while (true) {
    TaskStep step = task.step(now_);
    switch (step.kind) {
      case TaskStep::Kind::done: end(running); return Instant::never;
      case TaskStep::Kind::call: begin(running, std::move(step)); break;
      case TaskStep::Kind::cancel: cancel(std::move(step)); break;
      case TaskStep::Kind::wait: return step.until;
    }
  }
}

void PassiveClient::State::end(Running& running) {
  calls_->order().leave(running.joined);
  running.is_over = true;
  has_news_ = true;
  running.notices.reset();
  running.strays.reset();
  running.finish();
}

void PassiveClient::State::begin(Running& running, TaskStep step) {
  TaskMachine& task = *running.machine;
  const CallId id = step.call;
  if (!step.request) return task.replied(id, std::move(step.request).error());
  if (step.request->is_motion) join_order(running);
  using Key = detail::StreamListeners::Key;
  std::optional<Key> stream;
  if (step.stream_end) {
    stream = detail::StreamListeners::key_of(*step.request);
    task.keep(id, begin_stream(running, step));
  }
  step.options.on_confirmation = [this, &task, id](unsigned) {
    has_news_ = true;
    task.confirmed(id);
  };
  step.options.on_series = [this, &task, id](const Frame& frame) {
    has_news_ = true;
    task.received(id, {frame.body.begin(), frame.body.end()});
  };
  const std::uint32_t interval = step.request->policy.stream.interval_us;
  const auto replied = [this, &task, id, stream, interval](Result<Reply> reply) {
    has_news_ = true;
    // The board may have received the request, so the stream must be ended as well.
    const bool may_run = reply || reply.error().code == ErrorCode::timeout;
    if (stream && may_run) {
      const auto wanted = streams_.set_running(*stream, interval);
      if (wanted && reply) change_stream(*stream, *wanted);
    }
    if (!reply) task.keep(id, {});
    task.replied(id, std::move(reply));
  };
  const detail::CallPointer call =
      detail::make_call(id, *std::move(step.request), step.options, options_, now_, replied);
  call->task = task.number();
  if (auto refusal = calls_.begin(call)) {
    task.keep(id, {});
    task.replied(id, *std::move(refusal));
  }
}

/// The task must be known before its motion can be superseded.
void PassiveClient::State::join_order(Running& running) {
  TaskMachine& task = *running.machine;
  if (running.joined == task.number()) return;
  calls_->order().leave(running.joined);
  running.joined = task.number();
  calls_->order().join(running.joined, [this, &task](TaskNumber by) {
    has_news_ = true;
    task.supersede(by);
  });
}

/// Keeps a data stream running as long as it lives.
class PassiveClient::State::Stream : public Subscription::Registration {
 public:
  Stream(State& state, detail::StreamListeners::Key key, detail::StreamListeners::Listener listener,
         detail::Delivery::Registration samples)
      : state_(state), key_(std::move(key)), listener_(listener), samples_(std::move(samples)) {}
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() override {
    samples_.reset();
    state_.leave_stream(key_, listener_);
  }

 private:
  State& state_;
  const detail::StreamListeners::Key key_;
  const detail::StreamListeners::Listener listener_;
  detail::Delivery::Registration samples_;
};

Subscription PassiveClient::State::begin_stream(Running& running, TaskStep& step) {
  const auto key = detail::StreamListeners::key_of(*step.request);
  const auto listener = streams_.join(key, *step.request, *std::move(step.stream_end));
  step.request = streams_.fastest(key);
  const detail::MessageKey wanted{.id = step.request->policy.stream.command, .is_raw = true};
  auto take = [this, &task = *running.machine, key, listener, id = step.call](const Frame& frame) {
    if (!streams_.is_due(key, listener)) return;
    has_news_ = true;
    task.received(id, {frame.body.begin(), frame.body.end()});
  };
  return Subscription(std::make_unique<Stream>(
      *this, key, listener,
      delivery_.subscribe(wanted, detail::typed_handler<Frame>(std::move(take)))));
}

void PassiveClient::State::cancel(TaskStep step) {
  const detail::CallPointer call = calls_->take(step.call);
  if (!call) return;
  dialogue_.forget(*call);
  if (step.stream && call->was_sent) {
    streams_.set_running(detail::StreamListeners::key_of(call->request),
                         call->request.policy.stream.interval_us);
  }
}

void PassiveClient::State::leave_stream(const detail::StreamListeners::Key& key,
                                        detail::StreamListeners::Listener listener) {
  if (auto change = streams_.leave(key, listener)) change_stream(key, *std::move(change));
}

/// Ends the data stream if nobody wants it any more, or changes its interval.
void PassiveClient::State::change_stream(const detail::StreamListeners::Key& key,
                                         detail::Request request) {
  has_news_ = true;
  const std::uint32_t interval = request.policy.stream.interval_us;
  const auto changed = [this, key, interval](const Result<Reply>& reply) {
    if (interval == 0) return streams_.end_sent(key);
    const auto wanted = reply ? streams_.set_running(key, interval) : std::nullopt;
    if (wanted) change_stream(key, *wanted);
  };
  const detail::CallPointer call =
      detail::make_call(detail::next_call_id(), std::move(request), {}, options_, now_, changed);
  if (calls_.begin(call)) streams_.end_sent(key);
}

}  // namespace sbgc
