// Data streams: samples wait in a queue.

#include <deque>
#include <optional>

#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>

#include "arguments.hpp"
#include "link.hpp"

namespace sbgc::python {

namespace {

/// Samples that wait for Python. Beyond a limit, the oldest are dropped.
class SampleQueue {
 public:
  SampleQueue(std::shared_ptr<Bell> bell, VirtualTimePointer time)
      : bell_(std::move(bell)), time_(std::move(time)) {}

  void put(AnyMessage message) {
    {
      const std::scoped_lock lock(mutex_);
      if (samples_.size() == limit) {
        samples_.pop_front();
        ++missed_;
      }
      samples_.push_back(std::move(message));
    }
    changed_.notify_all();
    bell_->ring();
  }
  /// Returns the next sample; nothing if there is none within this time.
  std::optional<AnyMessage> take(Seconds seconds) {
    return released([&]() -> std::optional<AnyMessage> {
      if (time_) time_->run([this] { return has_sample(); }, time_->now() + duration_of(seconds));
      std::unique_lock lock(mutex_);
      const auto time = std::chrono::duration<double>(time_ ? 0 : seconds);
      if (!changed_.wait_for(lock, time, [this] { return !samples_.empty(); })) return {};
      std::optional<AnyMessage> sample(std::move(samples_.front()));
      samples_.pop_front();
      return sample;
    });
  }
  std::uint64_t missed() const {
    const std::scoped_lock lock(mutex_);
    return missed_;
  }
  void own(Subscription subscription) { subscription_ = std::move(subscription); }
  void cancel() { subscription_.cancel(); }

 private:
  static constexpr std::size_t limit = 4096;

  bool has_sample() const {
    const std::scoped_lock lock(mutex_);
    return !samples_.empty();
  }

  std::shared_ptr<Bell> bell_;
  VirtualTimePointer time_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<AnyMessage> samples_{};
  std::uint64_t missed_ = 0;
  Subscription subscription_{};
};

using QueuePointer = std::shared_ptr<SampleQueue>;

/// A message that boards stream.
struct StreamKind {
  const char* name = "";
  detail::MessageKey key{};
  detail::Conversation::StreamRequests (*requests)(const detail::Conversation&,
                                                   const roles::StreamRequest&,
                                                   const CallOptions&){};
  AnyMessage (*copy)(const void* sample){};
};

template <class M>
constexpr StreamKind kind_of{
    Meta<M>::info.name, detail::key_of<M>,
    [](const detail::Conversation& conversation, const roles::StreamRequest& request,
       const CallOptions& options) {
      return detail::stream_requests<M>(conversation, request, options);
    },
    [](const void* sample) { return any_of(*static_cast<const M*>(sample)); }};

const StreamKind& kind_named(const std::string& name) {
  const StreamKind* found = nullptr;
  roles::StreamMessages::for_each([&]<class M>(Type<M>) {
    if (name == Meta<M>::info.name) found = &kind_of<M>;
  });
  if (found == nullptr) throw py::value_error("the board has no stream of " + name);
  return *found;
}

roles::StreamRequest request_of(Seconds interval, const AnyMessage* request) {
  auto wanted = detail::stream_request<roles::StreamRequest>(milliseconds_of(interval, "interval"));
  if (!wanted) raise_client(wanted.error());
  if (request == nullptr) return *wanted;
  const auto* const given = request->get_if<roles::StreamRequest>();
  if (given == nullptr) throw py::type_error("request: the request of a stream is needed");
  roles::StreamRequest result = without_surplus(*given);
  roles::stream_interval(result) = roles::stream_interval(*wanted);
  return result;
}

Operation::Result result_of(const QueuePointer& queue, Result<Subscription> started) {
  const Result<void> result = started ? Result<void>() : started.error();
  if (started) queue->own(*std::move(started));
  return [queue, result] {
    if (!result) raise_client(result.error());
    return py::cast(queue);
  };
}

/// Starts the stream of the message with this name; its result is a SampleQueue.
std::shared_ptr<Operation> stream(const std::shared_ptr<Link>& link, const std::string& name,
                                  Seconds interval, const AnyMessage* given,
                                  std::optional<Seconds> timeout) {
  auto operation = link->begin();
  const CallOptions options{.timeout = timeout_of(timeout)};
  const StreamKind& kind = kind_named(name);
  const roles::StreamRequest request = request_of(interval, given);
  const auto queue = std::make_shared<SampleQueue>(link->bell(), link->time());
  const auto take = [queue, copy = kind.copy](const void* sample) { queue->put(copy(sample)); };
  if (const auto client = link->reconnecting()) {
    const auto prepare = [&kind, request, options](const detail::Conversation& conversation) {
      return kind.requests(conversation, request, options);
    };
    const std::chrono::microseconds every(std::int64_t{roles::stream_interval_us} *
                                          roles::stream_interval(request).raw());
    link->block(operation, [client, prepare, key = kind.key, take, every, options, queue] {
      return result_of(queue, client->keep_stream(prepare, key, take, every, options));
    });
    return operation;
  }
  const detail::Conversation conversation = link->conversation();
  const CallId id =
      conversation.start_stream(kind.requests(conversation, request, options), kind.key, take,
                                options, [operation, queue](Result<Subscription> started) {
                                  operation->end(result_of(queue, std::move(started)));
                                });
  operation->set_cancel([conversation, id] { conversation.cancel(id); });
  return operation;
}

}  // namespace

void bind_streams(py::module_& module, LinkClass& link) {
  py::class_<SampleQueue, QueuePointer>(module, "SampleQueue")
      .def("take", &SampleQueue::take)
      .def("cancel", &SampleQueue::cancel)
      .def_property_readonly("missed", &SampleQueue::missed);
  link.def("stream", &stream);
}

}  // namespace sbgc::python
