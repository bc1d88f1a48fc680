/// Validates the values of a message against the specification.
///
/// Decoding never rejects a value for its range; validate() does, and reports every violation.
/// Include the tables of the messages to validate: <sbgc/meta/control.hpp>, for example, or
/// <sbgc/meta/all.hpp>.
#pragma once

#include <type_traits>

#include <sbgc/internal/check.hpp>
#include <sbgc/internal/table.hpp>
#include <sbgc/internal/violations.hpp>
#include <sbgc/violation.hpp>

namespace sbgc {

/// Versions that support everything, on a board that lacks nothing.
inline constexpr Availability newest{0xFFFF, 0xFF};

namespace detail {

/// Returns true if validate() would report nothing.
template <class M>
constexpr bool is_plainly_valid(const M& message, const Availability& versions) {
  Check check(versions);
  check.members(message);
  return check.passed();
}

}  // namespace detail

/// Calls `report(const Violation&)` for every value in `message` that the specification does not
/// allow on a board with these versions (see versions_of()). Returns true if there is none.
///
/// Sentinels are allowed. Reserved bytes, unknown flags and unknown enum values are not checked,
/// because later firmware gives them a meaning. A value that a later version introduced is reported
/// if it is not 0, and an optional field whenever it is present. Fields that the board does not
/// use, depending on the values of other fields, may have any value. To check the message as a
/// whole, use is_supported(). In a constant expression, a message with violations does not compile.
template <class M, class Report>
constexpr bool validate(const M& message, const Availability& versions, Report&& report) {
  if (detail::is_plainly_valid(message, versions)) return true;
  auto* const user = const_cast<std::remove_cvref_t<Report>*>(&report);
  return detail::report_violations(detail::table_of<M>(), &message, versions,
                                   detail::call_report<std::remove_reference_t<Report>>, user);
}

/// The same for the newest board.
template <class M, class Report>
constexpr bool validate(const M& message, Report&& report) {
  return validate(message, newest, report);
}

/// True if the specification allows every value of `message`.
template <class M>
constexpr bool is_valid(const M& message) {
  return detail::is_plainly_valid(message, newest);
}

}  // namespace sbgc
