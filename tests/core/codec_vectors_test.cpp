// Decodes and encodes every vector of the reference codec (generator/sbgcgen/targets/vectors),
// which shares the model with the generated codec but none of its templates.

#include <filesystem>

#include <gtest/gtest.h>

#include <sbgc/surplus.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

namespace fs = std::filesystem;

const fs::path folder = SBGC_GENERATED "/vectors";

std::vector<std::string> families() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

Direction direction_of(const Json& json) {
  return json["direction"] == "to_board" ? Direction::to_board : Direction::from_board;
}

ByteVector body_of(const Json& json) { return from_hex(json["hex"].get<std::string>()); }

Json error_of(const Status& status) {
  return {{"code", name(status.code)}, {"field", status.field}, {"offset", status.offset}};
}

/// One line of a vector file.
class Vector {
 public:
  explicit Vector(const std::string& line) : json_(Json::parse(line)) { learn(); }

  bool has(const char* key) const { return json_.contains(key); }
  const Json& operator[](const char* key) const { return json_[key]; }
  std::string text(const char* key) const { return json_[key].get<std::string>(); }

  void check() const {
    if (!has("message")) return check_refused();
    const MessageType& type = message_type(text("message"));
    EXPECT_EQ(type.info->command, text("command"));
    EXPECT_EQ(type.info->id, json_["id"]);
    EXPECT_TRUE(type.info->direction == direction_of(json_) ||
                type.info->direction == Direction::both);
    if (has("hex")) check_decode(type);
    if (has("fields")) check_encode(type);
  }

 private:
  /// Learns the contexts from the messages before this one.
  void learn() {
    if (!has("after")) return;
    for (const Json& earlier : json_["after"]) {
      const ByteVector body = body_of(earlier);
      const MessageType* const type =
          find_message(direction_of(earlier), earlier["id"], body.size());
      ASSERT_NE(type, nullptr);
      auto message = type->make();
      EXPECT_TRUE(message.decode(body));
      message.teach(contexts_);
    }
  }

  void check_refused() const {
    const Status status =
        visit_received(json_["id"], body_of(json_), direction_of(json_), [](const auto&) {});
    EXPECT_EQ(error_of(status), json_["error"]);
  }

  /// Returns the type that dispatch must select.
  const MessageType* chosen(const MessageType& type) const {
    if (!has("chosen")) return &type;
    return json_["chosen"].is_null() ? nullptr : &message_type(text("chosen"));
  }

  void check_decode(const MessageType& type) const {
    const ByteVector bytes = body_of(json_);
    const ExactCopy body(bytes);
    EXPECT_EQ(find_message(direction_of(json_), json_["id"], bytes.size(), contexts_),
              chosen(type));
    auto message = type.make();
    const Status status = message.decode(body.get(), contexts_);
    if (has("error")) {
      EXPECT_EQ(error_of(status), json_["error"]);
      return;
    }
    ASSERT_TRUE(status) << error_of(status);
    EXPECT_EQ(dom_of(message), json_["fields"])
        << "differences: " << Json::diff(json_["fields"], dom_of(message));
    EXPECT_EQ(encoded_body(message), bytes);
  }

  void check_encode(const MessageType& type) const {
    auto message = type.make();
    read_dom(json_["fields"], message);
    ByteVector body(max_body_size);
    const WriteResult written = message.encode(body);
    body.resize(written.size);
    if (has("error")) {
      EXPECT_EQ(error_of(written.status), json_["error"]);
    } else {
      EXPECT_TRUE(written) << error_of(written.status);
      EXPECT_EQ(detail::to_hex(body), text("hex"));
    }
  }

  Json json_;
  Contexts contexts_{};
};

class Vectors : public testing::TestWithParam<std::string> {};

TEST_P(Vectors, HoldBothWays) {
  std::ifstream file(folder / (GetParam() + ".jsonl"));
  std::string line;
  std::size_t number = 0;
  while (std::getline(file, line)) {
    SCOPED_TRACE(GetParam() + ".jsonl:" + std::to_string(++number));
    const Vector vector(line);
    SCOPED_TRACE((vector.has("message") ? vector.text("message") + ": " : "") + vector.text("why"));
    ASSERT_NO_THROW(vector.check());
  }
  EXPECT_GT(number, 0U);
}

INSTANTIATE_TEST_SUITE_P(Families, Vectors, testing::ValuesIn(families()),
                         [](const auto& family) { return family.param; });

}  // namespace
}  // namespace sbgc::test
