/// Starting an operation with a completion token.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include <asio/any_io_executor.hpp>
#include <asio/associated_cancellation_slot.hpp>
#include <asio/associated_executor.hpp>
#include <asio/async_result.hpp>
#include <asio/cancellation_type.hpp>
#include <asio/execution/outstanding_work.hpp>
#include <asio/post.hpp>
#include <asio/prefer.hpp>

#include <sbgc/client/link.hpp>

namespace sbgc::detail {

/// Starts an operation with `begin(completion)`, which returns its Stop; the completion calls the
/// token's handler.
template <class R, class Token, class Begin>
auto initiate(const asio::any_io_executor& executor, Token& token, Begin&& begin) {
  return asio::async_initiate<Token, void(R)>(
      [executor](auto handler, std::decay_t<Begin> start) {
        auto on = asio::prefer(asio::get_associated_executor(handler, executor),
                               asio::execution::outstanding_work_t::tracked);
        // `stop` is set below. Before that, and after the operation has ended, there is nothing
        // to cancel. The operation does not hold `stop`, which may hold the operation.
        const auto is_over = std::make_shared<std::atomic<bool>>(false);
        const auto stop = std::make_shared<Stop>();
        if (auto slot = asio::get_associated_cancellation_slot(handler); slot.is_connected()) {
          slot.assign([stop, is_over](asio::cancellation_type) {
            if (*stop && !*is_over) (*stop)();
          });
        }
        // Handlers may be move-only, but std::function requires a copyable target.
        struct Pending {
          decltype(handler) complete;
          decltype(on) executor;
        };
        const auto pending = std::make_shared<Pending>(Pending{std::move(handler), std::move(on)});
        *stop = start(Completion<R>([pending, is_over](R result) {
          *is_over = true;
          auto last = std::move(pending->executor);
          asio::post(last, [pending, result = std::move(result)]() mutable {
            auto complete = std::move(pending->complete);
            complete(std::move(result));
          });
        }));
      },
      token, std::forward<Begin>(begin));
}

}  // namespace sbgc::detail
