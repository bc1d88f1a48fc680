/// Debug variables by name, for tests.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <sbgc/dispatch.hpp>

#include "host.hpp"

namespace sbgc::test {

/// Returns the values of all debug variables, read as the board announces them.
inline std::map<std::string, std::vector<double>> debug_values(Host& host) {
  const auto info = host.get<msg::DebugVarsInfo3>(msg::DebugVarsInfo3Request{});
  msg::DebugVars3::Context context;
  for (const msg::DebugVarInfo& one : info.vars) {
    EXPECT_TRUE(detail::announce(context.types, number_type(one.var_type.kind()), one.arr_size));
  }
  const Packets packets = host.ask(msg::DebugVars3Request{});
  msg::DebugVars3 values;
  if (packets.size() != 1 || !decode(std::span(packets[0].body), values, context)) {
    ADD_FAILURE() << "no values";
    return {};
  }
  EXPECT_TRUE(values.tail.empty()) << "more than was announced";
  std::map<std::string, std::vector<double>> result;
  std::size_t index = 0;
  for (const msg::DebugVarInfo& one : info.vars) {
    auto& list = result[std::string(one.var_name.data(), one.var_name.size())];
    do {
      if (index < values.var_value.size()) list.push_back(values.var_value[index++].value());
    } while (list.size() < one.arr_size);
  }
  EXPECT_EQ(index, values.var_value.size());
  return result;
}

}  // namespace sbgc::test
