#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sbgc/version.hpp>

namespace {

TEST(Version, AsANumberOrdersReleases) {
  static_assert(SBGC_VERSION ==
                SBGC_VERSION_MAJOR * 10000 + SBGC_VERSION_MINOR * 100 + SBGC_VERSION_PATCH);
  static_assert(SBGC_VERSION_MINOR < 100 && SBGC_VERSION_PATCH < 100, "they have two digits");
#if SBGC_VERSION < 100
  FAIL() << "0.1.0 is the first release";
#endif
}

TEST(Version, OfTheProtocolIsThatOfTheModel) {
  std::ifstream file(SBGC_GENERATED "/simplebgc.json");
  const auto model = nlohmann::json::parse(file);
  const auto& protocol = model["protocol"];
  EXPECT_EQ(protocol["name"], sbgc::protocol_name);
  EXPECT_EQ(protocol["revision"], sbgc::protocol_revision);
  EXPECT_EQ(protocol["date"], sbgc::protocol_date);
  EXPECT_EQ(std::stoull(model["fingerprint"].get<std::string>(), nullptr, 16),
            sbgc::model_fingerprint);
}

}  // namespace
