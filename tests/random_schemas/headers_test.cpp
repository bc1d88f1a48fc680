// The generated headers of a random protocol: settings, including share(), are those of
// random_messages.py, which shares the model with the generated code but none of the templates; a
// conversation compiles.

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/detector.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>

#include "support.hpp"

namespace sbgc::test {
namespace {

template <class... Messages>
Json names(TypeList<Messages...>) {
  return Json::array({Meta<Messages>::info.name...});
}

template <class M>
void check(const Json& line) {
  using Settings = ParametersOf<M>;
  EXPECT_EQ(Settings::copies, line["copies"]);
  EXPECT_EQ(names(typename Settings::Readers{}), line["readers"]);
  EXPECT_EQ(names(typename Settings::Writers{}), line["writers"]);
  M from{}, to{};
  from_dom(line["from"], from);
  from_dom(line["to"], to);
  if constexpr (Settings::copies > 1) {
    EXPECT_EQ(Settings::copy(to), line["copy"]);
    Settings::share(from, to);
  }
  EXPECT_EQ(to_dom(to), line["shared"])
      << "differences: " << Json::diff(line["shared"], to_dom(to));
  EXPECT_EQ(detail::to_hex(body_of(to)), line["hex"].get<std::string>());
}

TEST(Settings, AreSharedAsTheModelSays) {
  std::ifstream file(SBGC_GENERATED "/settings.jsonl");
  std::set<std::string> seen;
  std::string text;
  int number = 0;
  while (std::getline(file, text)) {
    SCOPED_TRACE("line " + std::to_string(++number) + " of settings.jsonl");
    const Json line = Json::parse(text);
    seen.insert(line["settings"].get<std::string>());
    ParameterMessages::for_each([&]<class M>(Type<M>) {
      if (line["settings"] != ParametersOf<M>::name) return;
      ASSERT_NO_THROW(check<M>(line));
    });
  }
  ParameterMessages::for_each([&]<class M>(Type<M>) {
    EXPECT_TRUE(seen.contains(ParametersOf<M>::name)) << ParametersOf<M>::name;
  });
}

}  // namespace

// A conversation in the protocol is compiled, not run.
void talk(Session& session, Instant now);

void talk(Session& session, Instant now) {
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) session.send(M{});
  });
  static_cast<void>(session.poll(now, [](const Event&) {}));
  if constexpr (Detector::lines != 0) {
    static Detector detector;
    static_cast<void>(detector.next(now));
  }
}

}  // namespace sbgc::test
