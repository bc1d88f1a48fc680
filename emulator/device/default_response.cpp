#include "device/default_response.hpp"

#include <algorithm>
#include <span>

namespace sbgc::emulator::detail {
namespace {

/// Writes a correlation field. Returns the body size that it requires.
std::size_t put_field(const CorrelationField& field, Body& body) {
  for (std::size_t i = 0; i < field.size; ++i) {
    body[field.offset + i] = static_cast<std::uint8_t>(field.value >> (8 * i));
  }
  return field.size == 0 ? 0 : std::size_t{field.offset} + field.size;
}

}  // namespace

void answer_in(RequestContext& context, const ResponseForm& form, Body& body, std::size_t size) {
  size = std::max<std::size_t>(size, form.min_size);
  for (const CorrelationField& field : form.correlation) {
    size = std::max(size, put_field(field, body));
  }
  context.answer_body(form.id, std::span(body).first(size));
}

void confirm_by(RequestContext& context, const ResponsePolicy& policy, Body& body) {
  if (policy.responses.confirmed == Confirmed::never) return;
  std::size_t size = put_field(policy.responses.confirmation, body);
  size = std::max(size, put_field(policy.result.field(), body));
  // Offsets count from the id of the confirmed command.
  const auto data = size > 1 ? std::span(body).subspan(1, size - 1) : std::span(body).first(0);
  for (unsigned i = 0; i < policy.confirmations; ++i) static_cast<void>(context.confirm(data));
}

}  // namespace sbgc::emulator::detail
