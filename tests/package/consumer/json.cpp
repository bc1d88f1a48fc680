#include <cstdio>

#include <sbgc/json_dom.hpp>
#include <sbgc/messages/peripherals.hpp>
#include <sbgc/meta/peripherals.hpp>

int main() {
  const auto json = sbgc::to_dom(sbgc::msg::BeepSound{});
  std::puts(json.dump().c_str());
  return json.empty() ? 1 : 0;
}
