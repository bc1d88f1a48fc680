/// The response to requests without a handler, from the model alone: a command that is new in the
/// specification needs no code here.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/exchange.hpp>
#include <sbgc/framing.hpp>

#include "device/request_context.hpp"

namespace sbgc::emulator {

namespace detail {

template <class Answer>
struct FirstOf {
  using type = Answer;
};
template <class First, class... Others>
struct FirstOf<TypeList<First, Others...>> {
  using type = First;
};

using Body = std::array<std::uint8_t, max_body_size>;

/// Writes a correlation field; returns the size that the body needs for it.
inline std::size_t put_echo(const Echo& echo, Body& body) {
  for (std::size_t i = 0; i < echo.size; ++i) {
    body[echo.offset + i] = static_cast<std::uint8_t>(echo.value >> (8 * i));
  }
  return echo.size == 0 ? 0 : std::size_t{echo.offset} + echo.size;
}

}  // namespace detail

/// Whether the model documents the request: not if its body may be anything.
template <class Request>
inline constexpr bool is_documented = Request::min_size != 0 || Request::max_size != max_body_size;

/// Sends an empty response with the correlation fields of the request, or confirms the request
/// where that is possible, or sends nothing.
template <class Request>
Outcome default_response(RequestContext& context, const Request& request) {
  if constexpr (!is_documented<Request>) {
    // Assumption: a real board does something undocumented here; this one does nothing.
    return Outcome::carried_out;
  } else {
    const Exchange exchange = exchange_of(request);
    detail::Body body{};
    if constexpr (requires { detail::FirstOf<AnswerOf<Request>>::type::command; }) {
      using Answer = typename detail::FirstOf<AnswerOf<Request>>::type;
      if (exchange.replies.answer_count != 0) {
        if (!is_supported<Answer>(context.versions())) return Outcome::carried_out;
        const AnswerForm& form = exchange.replies.answers[0];
        const WriteResult written = encode(Answer{}, body);
        std::size_t size = std::max<std::size_t>(written.size, form.min_size);
        for (const Echo& echo : form.echoes) size = std::max(size, detail::put_echo(echo, body));
        context.answer_body(form.id, std::span(body).first(size));
      }
    }
    if (exchange.replies.confirmed != Confirmed::never) {
      const ConfirmationResult& result = exchange.result;
      std::size_t size = detail::put_echo(exchange.replies.confirmation, body);
      size = std::max(size, detail::put_echo({result.offset, result.size, result.success}, body));
      // Offsets count from the id of the confirmed command.
      const auto data = size > 1 ? std::span(body).subspan(1, size - 1) : std::span(body).first(0);
      for (unsigned i = 0; i < exchange.confirmations; ++i)
        static_cast<void>(context.confirm(data));
    }
    return Outcome::carried_out;
  }
}

}  // namespace sbgc::emulator
