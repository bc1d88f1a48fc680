/// The data streams of boards, chosen by name.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/client/async_client.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/roles.hpp>

#include "frames/sample_writer.hpp"

namespace sbgc::tools {

/// A handler for a sample, which is valid during the call.
using SampleHandler = std::function<void(const Sample&)>;

/// A stream of one kind of message, and its configuration.
class StreamType {
 public:
  /// The name is that of a message or of its command, in any case. Throws CommandError with
  /// suggestions.
  static StreamType find(std::string_view name);

  const MessageInfo& info() const { return *type_->info; }

  /// Configures the contents of samples: "NAME=VALUE,…" sets fields of the request, and "A|B" its
  /// only set of flags. Throws CommandError.
  void configure(std::string_view with);
  /// Sets the flags of the request so that samples have the fields that these patterns select. Does
  /// nothing if samples do not depend on flags. Throws CommandError.
  void configure_for(std::string_view patterns);
  /// Returns the names of the flags that select the contents of samples; empty if there are none.
  std::vector<std::string> flags() const;
  /// True if samples depend on flags, but none of them is set.
  bool lacks_flags() const;

  /// Returns the fields of samples with this configuration, in wire order, without reserved ones.
  std::vector<StreamField> fields() const;

  /// Handles messages that arrive without a request, as from a capture.
  Subscription listen(Client& client, SampleHandler handler) const;
  /// Starts the stream.
  Result<Subscription> start(Client& client, std::chrono::milliseconds interval,
                             SampleHandler handler) const;
  /// The same; `done` and `handler` are called on the executor of the client.
  void async_start(AsyncClient& client, std::chrono::milliseconds interval,
                   std::function<void(const AnyMessage&)> handler,
                   std::function<void(Result<Subscription>)> done) const;

 private:
  explicit StreamType(const MessageType& type);

  roles::StreamRequest with_interval(std::int64_t count) const;
  Result<roles::StreamRequest> request(std::chrono::milliseconds interval) const;

  const MessageType* type_;
  AnyMessage request_;
};

/// Returns the request for the bytes of a stream, including unknown ones; `config` is its
/// configuration in hex. Throws CommandError.
roles::StreamRequest raw_stream_request(unsigned id, std::string_view config,
                                        std::chrono::milliseconds interval);

}  // namespace sbgc::tools
