// A program of a user: what is wrong with a gimbal that reports an error.

#include <cstdio>

#include <sbgc/doctor/findings.hpp>

int main() {
  sbgc::doctor::Measurements measured;
  measured.errors = sbgc::msg::SystemError::no_sensor;
  const auto findings = sbgc::doctor::findings_of(measured);
  for (const auto& one : findings) std::puts(one.sentence.c_str());
  return findings.size() == 1 ? 0 : 1;
}
