// A message whose type is known at run time, from an installed sbgc. Compiled without exceptions.

#include <cstdio>

#include <sbgc/any.hpp>

int main() {
  const sbgc::MessageType* const type = sbgc::find_message("GetAngles");
  if (type == nullptr) return 1;
  const sbgc::AnyMessage message = type->make();
  std::printf("%s\n", message.to_json().c_str());
  return to_string(message).empty() ? 1 : 0;
}
