// Plays rows.txt, which describes its rows.

#include <sstream>

#include <gtest/gtest.h>

#include <sbgc/json.hpp>
#include <sbgc/text.hpp>

#include "messages.hpp"

namespace sbgc::test {
namespace {

/// Returns true if the text is that of a row, in which "..." stands for any text.
bool is_like(std::string_view text, std::string_view row) {
  const std::size_t dots = row.find("...");
  if (dots == std::string_view::npos) return text == row;
  if (!text.starts_with(row.substr(0, dots))) return false;
  const std::string_view rest = row.substr(dots + 3);
  for (std::size_t at = dots; at <= text.size(); ++at) {
    if (is_like(text.substr(at), rest)) return true;
  }
  return false;
}

AnyMessage made(const std::string& row, Availability& versions) {
  std::istringstream words(row);
  std::string word;
  words >> word;
  if (const std::size_t slash = word.find('/'); slash != std::string::npos) {
    versions = {static_cast<std::uint16_t>(std::stoi(word)),
                static_cast<std::uint8_t>(std::stoi(word.substr(slash + 1)))};
    words >> word;
  }
  AnyMessage message = message_type(word).make();
  while (words >> word) {
    const std::size_t at = word.find('=');
    EXPECT_EQ(message.assign(word.substr(0, at), word.substr(at + 1), false), "");
  }
  return message;
}

std::string violations_text(const AnyMessage& message, const Availability& versions) {
  std::string result;
  message.validate(versions, [&](const Violation& violation) {
    result += (result.empty() ? "" : "; ") + to_string(violation);
  });
  EXPECT_EQ(passes_quick_check(message, versions), result.empty());
  return result.empty() ? "valid" : result;
}

/// By text, which by values of nlohmann_json agrees with.
std::string json_problem(const std::string& name, const std::string& json) {
  AnyMessage message = message_type(name).make();
  const AnyMessage before = message;
  const JsonResult result = message.from_json(json);
  EXPECT_TRUE(message == before);
  if (Json::accept(json)) {
    EXPECT_THROW(read_dom(Json::parse(json), message), JsonError);
    EXPECT_TRUE(message == before);
  }
  return result.problem ? to_string(*result.problem) : "";
}

/// A row about assign(): "MESSAGE PATH = TEXT > NUMBER" or "MESSAGE PATH = TEXT ? PROBLEM".
void check_assigned(const std::string& row) {
  const std::size_t space = row.find(' ');
  const std::size_t equals = row.find(" = ");
  const std::size_t end = row.find_last_of(">?");
  const std::string path = row.substr(space + 1, equals - space - 1);
  const std::string text = row.substr(equals + 3, end - equals - 4);
  AnyMessage message = message_type(row.substr(0, space)).make();
  const AnyMessage before = message;
  const bool is_refused = row[end] == '?';
  const std::string problem = message.assign(path, text, is_refused);
  EXPECT_EQ(is_refused, message == before);
  EXPECT_TRUE(is_like(problem, is_refused ? row.substr(end + 2) : "")) << problem;
  if (is_refused) return;
  message.with_leaf(
      path, [&](const Leaf& leaf) { EXPECT_EQ(leaf.integer, std::stoi(row.substr(end + 2))); });
}

void check_row(const std::string& row) {
  const auto after = [&](std::size_t at) { return row.substr(std::min(row.size(), at + 3)); };
  Availability versions = newest;
  if (const std::size_t at = row.rfind(" ! "); at != std::string::npos) {
    const std::size_t space = row.find(' ');
    const std::string json = row.substr(space + 1, at - space - 1);
    const std::string problem = json_problem(row.substr(0, space), json);
    EXPECT_TRUE(is_like(problem, after(at))) << problem;
  } else if (row.find(" = ") < row.find(" : ")) {
    check_assigned(row);
  } else if (const std::size_t bar = row.find(" | "); bar != std::string::npos) {
    const std::string found = violations_text(made(row.substr(0, bar), versions), versions);
    EXPECT_TRUE(is_like(found, after(bar))) << found;
  } else {
    const std::size_t colon = row.find(" : ");
    const std::string text = to_string(made(row.substr(0, colon), versions));
    EXPECT_TRUE(is_like(text, after(colon))) << text;
  }
}

TEST(Rows, AreTrue) {
  std::vector<std::string> rows;
  std::ifstream file(SBGC_ROWS);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (line.starts_with("    ")) {
      rows.back() += line.substr(3);
    } else {
      rows.push_back(line);
    }
  }
  EXPECT_GT(rows.size(), 100U);
  for (const std::string& row : rows) {
    SCOPED_TRACE(row);
    check_row(row);
  }
}

}  // namespace
}  // namespace sbgc::test
