// Data streams: samples are queued.

#include <deque>
#include <optional>

#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>

#include "arguments.hpp"
#include "link.hpp"

namespace sbgc::python {

namespace {

/// Queued samples for Python. Beyond a limit, the oldest are dropped. The stream ends with the
/// queue.
class SampleQueue {
 public:
  SampleQueue(std::shared_ptr<Bell> bell, VirtualTimePointer time)
      : bell_(std::move(bell)), time_(std::move(time)) {}
  SampleQueue(const SampleQueue&) = delete;
  SampleQueue& operator=(const SampleQueue&) = delete;
  ~SampleQueue() {
    // In a forked child, its client's locks may be locked forever.
    if (process_.is_forked()) static_cast<void>(subscription_.release());
  }

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
  std::optional<AnyMessage> take(double seconds) {
    process_.require("the client");
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
  void own(Subscription subscription) { *subscription_ = std::move(subscription); }
  void cancel() {
    if (!process_.is_forked()) subscription_->cancel();
  }

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
  Process process_{};
  std::unique_ptr<Subscription> subscription_ = std::make_unique<Subscription>();
};

using QueuePointer = std::shared_ptr<SampleQueue>;

const MessageType& stream_type(const std::string& name) {
  for (const MessageType* const type : stream_types()) {
    if (name == type->info->name) return *type;
  }
  throw py::value_error("the board has no stream of " + name);
}

roles::StreamRequest request_of(std::chrono::milliseconds interval, const AnyMessage* request) {
  auto wanted = detail::stream_request<roles::StreamRequest>(interval);
  if (!wanted) raise_client(wanted.error());
  if (request == nullptr) return *wanted;
  const auto* const given = request->get_if<roles::StreamRequest>();
  if (given == nullptr) throw py::type_error("request: the request of a stream is needed");
  roles::StreamRequest result = without_surplus(*given);
  roles::stream_interval(result) = roles::stream_interval(*wanted);
  return result;
}

/// The stream of the message with this name; the result of the operation is a SampleQueue.
std::shared_ptr<Operation> stream(Link& link, const std::string& name, Seconds<"interval"> interval,
                                  const AnyMessage* given, OptionalSeconds<"timeout"> timeout) {
  auto operation = link.make_operation();
  const CallOptions options{.timeout = timeout};
  const MessageType& type = stream_type(name);
  const roles::StreamRequest request = request_of(interval, given);
  const auto queue = std::make_shared<SampleQueue>(link.bell(), link.time());
  using Begun = Result<Subscription>;
  link.prepare<Begun>(
      *operation,
      [&type, request, options, weak = std::weak_ptr(queue)](AsyncClient& client, auto token) {
        const auto put = [weak](const AnyMessage& one) {
          if (const auto to = weak.lock()) to->put(one);
        };
        client.async_stream(type, request, put, options, std::move(token));
      },
      [queue](Begun begun) -> Operation::Result {
        const Result<void> result = begun ? Result<void>() : begun.error();
        if (begun) queue->own(*std::move(begun));
        return [queue, result] {
          if (!result) raise_client(result.error());
          return py::cast(queue);
        };
      });
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
