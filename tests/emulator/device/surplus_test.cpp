// Tests of requests that are longer than the board knows: it ignores the surplus, like real boards.

#include <fstream>
#include <map>

#include <sbgc/json_dom.hpp>

#include "host.hpp"
#include "random_input.hpp"

namespace sbgc::test {
namespace {

using emulator::BoardOptions;
using emulator::Reaction;

BoardOptions with_firmware(std::uint8_t board, std::uint16_t firmware) {
  BoardOptions options;
  options.board = msg::BoardVersion(board);
  options.firmware = msg::FirmwareVersion(firmware);
  return options;
}

/// Returns 2687 for "2.68b7", 2740 for "2.74", 2745 for "2.74.5", 36 for "3.6".
unsigned number_of(const std::string& version) {
  unsigned number = 0;
  unsigned digits = 0;  // since the point
  bool is_behind_point = false;
  for (const char c : version) {
    if (c == '.') is_behind_point = true;
    if (c < '0' || c > '9') continue;
    number = number * 10 + static_cast<unsigned>(c - '0');
    digits += is_behind_point ? 1 : 0;
  }
  return digits == 2 ? number * 10 : number;
}

/// True if a board has what the exported model says about versions; null: every board.
bool has(const BoardOptions& board, const Json& since) {
  if (since.is_null()) return true;
  return number_of(since.value("firmware", "0")) <= board.firmware.raw() &&
         number_of(since.value("board", "0")) <= board.board.raw();
}

/// The requests of the exported model, and what this test needs to know of them.
class Requests {
 public:
  Requests() {
    std::ifstream file(SBGC_GENERATED "/simplebgc.json");
    const Json model = Json::parse(file);
    for (const Json& message : model["messages"]) {
      if (message["direction"] == "to_board") forms_[message["id"]].push_back(message);
    }
  }

  const std::map<std::uint8_t, std::vector<Json>>& by_id() const { return forms_; }

  /// Returns how a board should handle a request of zeros.
  Reaction expected(const BoardOptions& board, std::uint8_t id, std::size_t size) const {
    bool is_known = false, is_open = false;
    std::size_t largest = 0;
    std::size_t longest_form = 0;
    for (const Json& form : forms_.at(id)) longest_form = std::max(longest_form, most(form));
    for (const Json& form : forms_.at(id)) {
      if (!has(board, form["since"])) continue;
      if (!form["until"].is_null() && has(board, form["until"])) continue;
      is_known = true;
      const std::size_t known = most_on(board, form);
      if (known >= largest) is_open = has_open_end(board, form);
      largest = std::max(largest, known);
      const bool may_be_longer = has_open_end(board, form) && most(form) == longest_form;
      if (size < form["min_size"] || (size > known && !may_be_longer)) continue;
      const std::vector<std::uint8_t> body(size);
      const MessageType& type = *find_message(form["name"].get<std::string>());
      if (type.make().decode(body)) return Reaction::executed;
    }
    if (!is_known) return Reaction::unknown;
    return size > largest && !is_open ? Reaction::executed : Reaction::malformed;
  }

 private:
  static std::size_t most(const Json& form) { return form["max_size"]; }
  /// True if the leaf is a list that later firmware has added.
  static bool is_later_list(const BoardOptions& board, const Json& leaf) {
    return leaf["count"].is_null() && leaf.contains("since") && !has(board, leaf["since"]);
  }
  /// The size of the form with all fields that the firmware has.
  static std::size_t most_on(const BoardOptions& board, const Json& form) {
    for (const Json& leaf : form["layout"]) {
      if (is_later_list(board, leaf)) return leaf["offset"];
    }
    if (!form.contains("sizes")) return most(form);
    std::size_t size = 0;
    for (const Json& one : form["sizes"]) {
      if (has(board, one["since"])) size = std::max<std::size_t>(size, one["size"]);
    }
    return size;
  }
  /// True if the form has a list or bytes without a fixed number, or keeps a tail itself.
  static bool has_open_end(const BoardOptions& board, const Json& form) {
    return form["keeps_tail"].get<bool>() ||
           std::ranges::any_of(form["layout"], [&](const Json& leaf) {
             const bool is_of_list = leaf.value("may_be_missing", false) &&
                                     !leaf.contains("when") && !form.contains("sizes");
             return (leaf["count"].is_null() && !is_later_list(board, leaf)) || is_of_list;
           });
  }

  std::map<std::uint8_t, std::vector<Json>> forms_{};
};

bool restarts(const std::vector<Json>& forms) {
  return std::ranges::any_of(forms, [](const Json& form) {
    return std::ranges::count(form["effect"]["does"], "restarts") != 0;
  });
}

/// Sends a request of zeros; returns how the board handled it.
Reaction verdict_of(Host& host, std::uint8_t id, std::size_t size, Packets& packets) {
  Reaction reaction = Reaction::lost;
  host.board.on_traffic = [&](const emulator::Board::Traffic& traffic) {
    if (traffic.reaction) reaction = *traffic.reaction;
  };
  host.send_bytes(frame_of(id, std::vector<std::uint8_t>(size)));
  packets = host.listen(milliseconds(1));
  host.board.on_traffic = nullptr;
  return reaction;
}

class EveryFirmware : public testing::TestWithParam<std::array<std::uint16_t, 2>> {};

TEST_P(EveryFirmware, TakesEveryRequestAtEverySizeAsTheModelSays) {
  const auto [board, firmware] = GetParam();
  const BoardOptions options = with_firmware(static_cast<std::uint8_t>(board), firmware);
  static const Requests requests;  // which takes a second to read
  for (const auto& [id, forms] : requests.by_id()) {
    SCOPED_TRACE(forms.front()["command"]);
    Host host(options);
    for (std::size_t size = 0; size <= max_body_size; ++size) {
      Packets packets;
      const Reaction reaction = verdict_of(host, id, size, packets);
      const Reaction expected = requests.expected(options, id, size);
      // Zeros may be wrong values, which is not about the size.
      const bool agrees = expected == Reaction::executed
                              ? reaction == Reaction::executed || reaction == Reaction::refused
                              : reaction == Reaction::unknown || reaction == Reaction::malformed;
      ASSERT_TRUE(agrees) << size << " bytes: " << static_cast<int>(reaction);
      const auto errors = all<msg::ErrorExt>(packets);
      const bool is_about_size =
          !errors.empty() && errors.front().error_code == msg::BoardErrorCode::cmd_size;
      const bool has_errors =
          is_supported<msg::ErrorExt>(Availability{options.firmware.raw(), options.board.raw()});
      ASSERT_EQ(is_about_size, has_errors && expected == Reaction::malformed) << size << " bytes";
      if (!restarts(forms)) continue;
      host.board.restart(host.now);
      host.listen(options.start_time + milliseconds(1));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Versions, EveryFirmware,
                         testing::Values(std::array<std::uint16_t, 2>{10, 2200},
                                         std::array<std::uint16_t, 2>{30, 2439},
                                         std::array<std::uint16_t, 2>{30, 2626},
                                         std::array<std::uint16_t, 2>{36, 2687},
                                         std::array<std::uint16_t, 2>{36, 2708},
                                         std::array<std::uint16_t, 2>{36, newest_firmware}),
                         [](const auto& test) { return std::to_string(test.param[1]); });

}  // namespace
}  // namespace sbgc::test
