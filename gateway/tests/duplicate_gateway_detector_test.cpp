// Two gateways of one fleet, each of which reads the states of both.

#include "gateway/duplicate_gateway_detector.hpp"

#include <chrono>
#include <initializer_list>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include <sbgc/json_dom.hpp>

namespace sbgc::tools {
namespace {

using namespace std::chrono_literals;

std::string state_of(const DuplicateGatewayDetector& gateway) {
  Json state{{"version", 1}, {"state", "online"}};
  gateway.sign(state);
  return detail::json_text(state);
}

DuplicateGatewayDetector later_one() {
  std::this_thread::sleep_for(5ms);
  return {};
}

class TwoGateways : public testing::Test {
 protected:
  /// Simulates that the other gateway took the connection, and this one took it back.
  bool gives_way(DuplicateGatewayDetector& reader, const DuplicateGatewayDetector& other,
                 std::chrono::seconds time) {
    reader.read(state_of(reader), start_ + time);
    return reader.read(state_of(other), start_ + time);
  }

  const DuplicateGatewayDetector::Clock::time_point start_{};
  DuplicateGatewayDetector first_{};
  DuplicateGatewayDetector second_ = later_one();
};

TEST_F(TwoGateways, TheLaterOneGivesWay) {
  EXPECT_FALSE(gives_way(second_, first_, 1s));
  EXPECT_TRUE(gives_way(second_, first_, 2s));
}

TEST_F(TwoGateways, TheFirstOneStays) {
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(gives_way(first_, second_, 1s));
}

TEST_F(TwoGateways, WhatAnEarlierProcessHasLeftIsNoRival) {
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(second_.read(state_of(first_), start_));
  EXPECT_FALSE(gives_way(second_, second_, 1s));
}

TEST_F(TwoGateways, AnOldStateThatABrokerBringsBackIsNoRival) {
  for (const auto time : {0s, 60s, 120s}) EXPECT_FALSE(gives_way(second_, first_, time));
}

TEST_F(TwoGateways, WhatIsNoState) {
  const std::string deep = std::string(30'000, '[') + std::string(30'000, ']');
  for (const std::string& text : std::initializer_list<std::string>{
           "", "{", "[]", "1", "null", deep, R"({"state": "online"})", R"({"since": 1})",
           R"({"since": "1", "process": "a"})", R"({"since": 1, "process": 2})",
           R"({"since": {}, "process": []})", "\xFF"}) {
    for (int i = 0; i < 3; ++i) {
      second_.read(state_of(second_), start_);
      EXPECT_FALSE(second_.read(text, start_)) << text;
    }
  }
}

}  // namespace
}  // namespace sbgc::tools
