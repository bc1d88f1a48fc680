#include "gateway/duplicate_gateway_detector.hpp"

#include <random>
#include <utility>

#include <fmt/format.h>

#include "gateway/payload.hpp"

namespace sbgc::tools {

namespace {

/// A broker that was killed may restore an old state: only the second occurrence counts, if it is
/// soon.
constexpr std::chrono::minutes soon{1};

std::string random_name() {
  std::random_device source;
  return fmt::format("{:08x}{:08x}", source(), source());
}

}  // namespace

DuplicateGatewayDetector::DuplicateGatewayDetector()
    : name_{unix_milliseconds(std::chrono::system_clock::now()), random_name()} {}

void DuplicateGatewayDetector::sign(Json& state) const {
  state["since"] = name_.first;
  state["process"] = name_.second;
}

bool DuplicateGatewayDetector::read(const std::string& state, Clock::time_point now) {
  const Json json = Json::parse(state, nullptr, false);
  const auto since = json.find("since");
  const auto process = json.find("process");
  const bool is_signed = since != json.end() && since->is_number_integer() &&
                         process != json.end() && process->is_string();
  if (!is_signed) return false;
  const Name name{since->get<std::int64_t>(), process->get<std::string>()};
  if (name.second == name_.second) {
    has_read_own_ = true;
    return false;
  }
  if (!std::exchange(has_read_own_, false) || name > name_) return false;
  const auto earlier = std::exchange(noticed_, now);
  return earlier && now < *earlier + soon;
}

}  // namespace sbgc::tools
