// Plays the conversations with an emulated board that are in conversations/*.txt. README.txt in
// that folder describes their rows: a request, or what happens to the board, and what is the
// answer.

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <sbgc/json/hex.hpp>
#include <sbgc/text.hpp>
#include <sbgc/value_text.hpp>

#include "answers.hpp"
#include "random_input.hpp"

namespace sbgc::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

struct Conversation {
  std::string name{};
  std::vector<std::pair<std::string, std::string>> rows{};  // with their places

  // NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
  friend void PrintTo(const Conversation& one, std::ostream* out) { *out << one.name; }
};

std::vector<Conversation> conversations() {
  std::vector<Conversation> result;
  for (const auto& file : fs::directory_iterator(SBGC_CONVERSATIONS)) {
    std::ifstream lines(file.path());
    const std::string name = file.path().filename().string();
    if (name == "README.txt") continue;
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (line.starts_with("== ")) {
        result.push_back({file.path().stem().string() + "_" + line.substr(3)});
        std::erase_if(result.back().name, [](char c) { return std::isalnum(c) == 0 && c != '_'; });
      } else if (line.starts_with("    ")) {
        result.back().rows.back().second += line.substr(3);
      } else if (!line.empty() && line[0] != '#') {
        std::string row = name + ":";
        row.append(std::to_string(number)).append(": ").append(line);
        result.back().rows.emplace_back(std::move(row), line);
      }
    }
  }
  std::ranges::sort(result, {}, &Conversation::name);
  return result;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

Words words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

Duration duration_of(const std::string& text) {
  const double number = std::stod(text);
  if (text.ends_with("ms")) return microseconds(std::llround(number * 1e3));
  if (text.ends_with("us")) return microseconds(std::llround(number));
  return microseconds(std::llround(number * 1e6));
}

emulator::BoardOptions options_of(const Words& words) {
  emulator::BoardOptions options;
  for (const std::string& word : words) {
    if (word == "newest") {
      options = newest_board();
    } else if (word.starts_with("firmware=")) {
      options.firmware =
          msg::FirmwareVersion(static_cast<std::uint16_t>(std::stoi(word.substr(9))));
    } else if (word.starts_with("version=")) {
      options.board = msg::BoardVersion(static_cast<std::uint8_t>(std::stoi(word.substr(8))));
    } else if (word == "strict") {
      options.is_strict = true;
    } else if (word.starts_with("frame=")) {
      Axes<double> angles;
      std::istringstream numbers(word.substr(6));
      char comma{};
      numbers >> angles.roll >> comma >> angles.pitch >> comma >> angles.yaw;
      options.gimbal.frame = {emulator::Disturbance::Kind::recorded, 1, {{Instant{}, angles}}};
    } else if (word.starts_with("start=")) {
      options.start_time = duration_of(word.substr(6));
    } else if (word.starts_with("bootloader=")) {
      options.bootloader_time = duration_of(word.substr(11));
    } else if (word == "saving") {
      options.waits_for_saving = true;
    } else if (word == "still") {
      options.gimbal.noise = 0;
    } else if (word.starts_with("password=")) {
      options.password = word.substr(9);
    } else if (word.starts_with("device_id=")) {
      options.device_id[0] = static_cast<std::uint8_t>(std::stoi(word.substr(10)));
    } else if (word == "instant") {
      options.calibration_time = 0;
    } else if (word == "frame_imu=no") {
      options.has_frame_imu = false;
    } else if (word == "features=three_axis") {
      options.features = msg::BoardFeature::three_axis;
    } else if (word == "features_ext=no") {
      options.features_ext = {};
    } else if (word == "features_ext2=no") {
      options.features_ext2 = {};
    } else {
      throw std::invalid_argument("unknown option " + word);
    }
  }
  return options;
}

/// A check of a value: "path=value", "path!=value", "path~value:error", "path<value", "path>value",
/// "bytes^beginning", "flags@name", "flags!@name".
struct Claim {
  std::string path{}, comparison{}, value{};
};
Claim claim_of(const std::string& word) {
  const std::size_t at = word.find_first_of("!=~<>^@");
  if (at == std::string::npos) throw std::invalid_argument("no comparison: " + word);
  const std::size_t size = word[at] == '!' ? 2 : 1;
  return {word.substr(0, at), word.substr(at, size), word.substr(at + size)};
}

bool holds(double number, const Claim& claim) {
  const double value = std::stod(claim.value);
  if (claim.comparison == "<") return number < value;
  if (claim.comparison == ">") return number > value;
  if (claim.comparison == "=") return number == value;
  if (claim.comparison == "!=") return number != value;
  const std::size_t colon = claim.value.find(':');
  if (colon == std::string::npos) throw std::invalid_argument("no error: " + claim.value);
  return std::abs(number - value) <= std::stod(claim.value.substr(colon + 1));
}

/// Returns the values at a path and below it; "" means all.
std::string values_at(const AnyMessage& message, const std::string& path) {
  std::string result;
  message.for_each_leaf([&](const Leaf& leaf) {
    const std::string own = to_string(leaf.path);
    const bool is_below =
        own.starts_with(path) && (own.size() == path.size() || path.empty() ||
                                  own[path.size()] == '.' || own[path.size()] == '[');
    if (is_below) result += own + "=" + raw_text(leaf) + " ";
  });
  return result;
}

double number_at(const AnyMessage& message, const std::string& path) {
  double result = std::nan("");
  message.with_leaf(
      path, [&](const Leaf& leaf) { result = std::strtod(value_text(leaf).c_str(), nullptr); });
  EXPECT_FALSE(std::isnan(result)) << "no number at " << path;
  return result;
}

/// Returns the values of all debug variables, read as the board announces them.
std::map<std::string, std::vector<double>> debug_values(Host& host) {
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

class Player {
 public:
  void play(const std::string& row) {
    if (const std::size_t arrow = row.find(" =>"); arrow != std::string::npos) {
      return model(words_of(row.substr(0, arrow)), words_of(row.substr(arrow + 3)));
    }
    const std::size_t arrow = row.find("->");
    const Words left = words_of(row.substr(0, arrow));
    row_ = row;
    const Packets packets = act(left);
    if (arrow == std::string::npos) return;
    std::istringstream answers(row.substr(arrow + 2));
    for (std::string one; std::getline(answers, one, '&');) expect(packets, words_of(one));
  }

 private:
  const MessageType& type_of(const std::string& name) {
    if (const MessageType* const type = find_message(name)) return *type;
    throw std::invalid_argument("no message " + name);
  }
  Host& host() {
    if (!host_) host_ = std::make_unique<Host>();
    return *host_;
  }

  /// [new [OPTION]] MESSAGE FIELD=VALUE...
  void model(Words words, const Words& open) {
    if (words.at(0) == "new") {
      const bool has_options = find_message(words.at(1)) == nullptr;
      const auto begin = words.begin() + 1;
      act(has_options ? Words{"board", *begin} : Words{"board"});
      words.erase(words.begin(), begin + (has_options ? 1 : 0));
    }
    const AnyMessage request = made(words);
    const std::string comes = open.empty() ? "" : open[0];
    expect_as_modelled(host(), request,
                       comes == "confirmation" ? Comes::confirmation
                       : comes == "nothing"    ? Comes::nothing
                                               : Comes::as_modelled);
  }

  Packets act(const Words& words) {
    const std::string& verb = words.at(0);
    const Words rest(words.begin() + 1, words.end());
    if (verb == "board") {
      host_ = std::make_unique<Host>(options_of(rest));
      ports_ = 1;
      saved(0);
      return {};
    }
    emulator::Gimbal& gimbal = host().board.gimbal();
    const auto number = [&](std::size_t i) { return std::stod(rest.at(i)); };
    const auto axis = [&] { return static_cast<std::size_t>(number(0)); };
    if (verb == "wait") return host().listen(duration_of(rest.at(0)));
    if (verb == "restart") {
      host().board.restart(host().now);
      return host().listen(seconds(1));
    }
    if (verb == "place") {
      gimbal.place({number(0), number(1), number(2)}, host().now);
    } else if (verb == "battery") {
      gimbal.set_battery(number(0), host().now);
    } else if (verb == "jam") {
      gimbal.jam(axis(), true, host().now);
    } else if (verb == "saved") {
      saved(rest.empty() ? 0 : static_cast<std::uint32_t>(number(0)));
    } else if (verb == "unsaved") {
      host().board.memory_not_saved(host().board.memory().revision, host().now);
    } else if (verb == "turn") {
      gimbal.command(axis(), {.mode = emulator::AxisMode::speed, .speed = number(1)}, host().now);
    } else if (verb == "port") {
      port(axis());
    } else if (verb == "leave") {
      host().board.close_port(host().port);
      EXPECT_EQ(host().board.open_port(), host().port) << "the next host has the same port";
    } else if (verb == "truth") {
      for (const std::string& word : rest) {
        const Claim claim = claim_of(word);
        EXPECT_TRUE(holds(truth(claim.path), claim)) << word << ", it is " << truth(claim.path);
      }
    } else if (verb == "debug") {
      for (const std::string& word : rest) {
        const Claim claim = claim_of(word);
        const double value = debug_values(host()).at(claim.path).at(0);
        EXPECT_TRUE(holds(value, claim)) << word << ", it is " << value;
      }
    } else if (verb == "frame") {
      const auto bytes = detail::from_hex(rest.size() > 1 ? rest[1] : "");
      host().send_bytes(frame_of(static_cast<std::uint8_t>(axis()), bytes.value()));
      return host().listen(milliseconds(50));
    } else if (verb == "bytes") {
      host().send_bytes(detail::from_hex(rest.at(0)).value());
    } else if (verb == "framing") {
      host().framing = rest.at(0) == "v2" ? Framing::v2 : Framing::v1;
    } else if (verb == "store") {
      AnyMessage file = type_of("WriteFile").make();
      assign(file, "file_id=" + rest.at(0));
      std::string text = row_.substr(row_.find(rest[0]) + rest[0].size() + 1);
      std::ranges::replace(text, '|', '\n');
      assign(file, "file_size=" + std::to_string(text.size()));
      assign(file, "data=" + detail::to_hex(std::span(
                                 reinterpret_cast<const std::uint8_t*>(text.data()), text.size())));
      expect(send(file, milliseconds(50)), {"confirmed"});
    } else if (verb == "change") {
      change(rest);
    } else if (verb == "keep") {
      const Packets packets = ask({rest.begin() + 1, rest.end()});
      EXPECT_EQ(packets.size(), 1U);
      kept_.insert_or_assign(rest.at(0), decoded(packets.at(0)));
    } else
      return ask(words);
    return {};
  }

  /// All but the last changes of the memory.
  void saved(std::uint32_t without) {
    host().board.memory_saved(host().board.memory().revision - without, host().now);
  }

  void port(std::size_t number) {
    while (ports_ <= number) EXPECT_EQ(host().board.open_port(), ports_++);
    host().port = number;
  }

  double truth(const std::string& name) {
    const emulator::Board& board = host().board;
    if (name == "motors") return host().board.gimbal().motors_on() ? 1 : 0;
    if (name == "profile") return board.memory().profile;
    if (name == "restarts") return static_cast<double>(board.counters().restarts);
    if (name == "sent") return static_cast<double>(board.counters().sent);
    if (name == "unknown") return static_cast<double>(board.counters().unknown);
    if (name == "refused") return static_cast<double>(board.counters().refused);
    if (name == "baud") return board.baud_rate();
    if (name == "quiet") return board.is_quiet(host().port) ? 1 : 0;
    if (name == "loaded") {
      std::size_t size = 0;
      for (const auto& one : board.module_firmware()) size += one.second.size();
      return static_cast<double>(size);
    }
    const emulator::Sample sample = host().board.gimbal().sample(host().now);
    if (name == "gyro.z") return sample.gyro.z;
    const std::map<std::string, Axes<double>> axes{{"angles", sample.angles},
                                                   {"targets", sample.targets},
                                                   {"joints", sample.joints},
                                                   {"power", sample.power},
                                                   {"target_speeds", sample.target_speeds}};
    const std::size_t dot = name.find('.');
    const Axes<double>& values = axes.at(name.substr(0, dot));
    const std::string axis = name.substr(dot + 1);
    return axis == "roll" ? values.roll : axis == "pitch" ? values.pitch : values.yaw;
  }

  void assign(AnyMessage& message, const std::string& word) {
    const std::size_t at = word.find('=');
    if (at == std::string::npos) throw std::invalid_argument("no value: " + word);
    EXPECT_EQ(message.assign(word.substr(0, at), word.substr(at + 1), false), "");
  }

  Bytes frame_bytes(const AnyMessage& message) {
    asked_ = message.type().info;
    message.teach(contexts_);
    Bytes frame(max_frame_size);
    const WriteResult written = message.encode_frame(host().framing, frame);
    EXPECT_TRUE(written) << to_string(written.status);
    frame.resize(written.size);
    return frame;
  }

  Packets send(const AnyMessage& message, Duration wait) {
    host().send_bytes(frame_bytes(message));
    return host().listen(wait);
  }

  AnyMessage made(const Words& words) {
    AnyMessage message = type_of(words.at(0)).make();
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (words[i][0] != '+') assign(message, words[i]);
    }
    return message;
  }

  Packets ask(const Words& words) {
    const bool waits = words.back()[0] == '+';
    return send(made(words), waits ? duration_of(words.back().substr(1)) : milliseconds(50));
  }

  /// Reads parameters, changes some and writes them.
  void change(const Words& words) {
    AnyMessage request = type_of(words.at(0) + "Request").make();
    std::size_t first = 1;
    if (words.at(1).starts_with("profile_id=")) assign(request, words[first++]);
    const Packets read = send(request, milliseconds(50));
    AnyMessage write = type_of("Write" + words[0].substr(4)).make();
    ASSERT_EQ(read.size(), 1U);
    ASSERT_TRUE(write.decode(read[0].body));
    for (std::size_t i = first; i < words.size(); ++i) assign(write, words[i]);
    expect(send(write, milliseconds(50)), {"confirmed"});
  }

  AnyMessage decoded(const Packet& packet) {
    const MessageType* const type =
        find_message(Direction::from_board, packet.id, packet.body.size(), contexts_);
    if (type == nullptr) throw std::runtime_error("an unknown message");
    AnyMessage result = type->make();
    EXPECT_TRUE(result.decode(packet.body, contexts_));
    return result;
  }

  bool holds_in(const AnyMessage& message, const std::string& word) {
    Claim claim = claim_of(word);
    if (claim.path == "has") return message.has(claim.value);
    if (claim.path == "lacks") return !message.has(claim.value);
    if (claim.path.starts_with('#')) {
      return holds(static_cast<double>(message.count(claim.path.substr(1))), claim);
    }
    if (claim.comparison == "@" || claim.comparison == "!@") {
      std::string text;
      message.with_leaf(claim.path, [&](const Leaf& leaf) { text = lower(value_text(leaf)); });
      return (text.find(claim.value) != std::string::npos) == (claim.comparison == "@");
    }
    if (claim.comparison == "^") {
      return values_at(message, claim.path).starts_with(claim.path + "=" + claim.value);
    }
    const bool is_kept = claim.value.starts_with('$');
    if (claim.comparison == "=" || claim.comparison == "!=") {
      bool is_equal = false;
      if (is_kept) {
        is_equal = values_at(message, claim.path) ==
                   values_at(kept_.at(claim.value.substr(1)), claim.path);
      } else {
        AnyMessage same = message;
        EXPECT_EQ(same.assign(claim.path, claim.value, false), "");
        is_equal = same == message;
      }
      return is_equal == (claim.comparison == "=");
    }
    if (is_kept) {
      claim.value = std::to_string(number_at(kept_.at(claim.value.substr(1)), claim.path));
    }
    return holds(number_at(message, claim.path), claim);
  }

  bool is_confirmation(const AnyMessage& message) {
    const auto* const confirm = message.get_if<msg::Confirm>();
    return confirm != nullptr && static_cast<std::uint8_t>(confirm->cmd) == asked_->id;
  }

  /// The words after "->": [among] [last] NUMBER*NAME CLAIM..., or a way to say that no more comes.
  void expect(const Packets& packets, Words words) {
    std::vector<AnyMessage> found;
    for (const Packet& packet : packets) {
      found.push_back(decoded(packet));
      EXPECT_EQ(packet.framing, host().framing) << "that of the last request";
    }
    const auto take = [&](const char* word) {
      const bool is_there = !words.empty() && words[0] == word;
      if (is_there) words.erase(words.begin());
      return is_there;
    };
    const bool is_among = take("among"), is_last = take("last");
    std::string name = words.at(0);
    std::size_t number = 1;
    if (const std::size_t star = name.find('*'); star != std::string::npos) {
      number = static_cast<std::size_t>(std::stoi(name));
      name = name.substr(star + 1);
    }
    if (name == "nothing") number = 0;
    const ValueInfo* error = nullptr;
    for (const ValueInfo& info : EnumMeta<msg::BoardErrorCode>::info.values) {
      if (lower(info.name) == name) error = &info;
    }
    if (name == "confirmed" && words.size() > 1 && find_message(words[1]) != nullptr) {
      asked_ = type_of(words[1]).info;
      words.erase(words.begin() + 1);
    }
    if (!is_among && !is_last) {
      EXPECT_EQ(found.size(), number);
    }
    const bool is_named = name != "confirmed" && name != "nothing" && error == nullptr;
    if (is_named) type_of(name);
    std::erase_if(found, [&](const AnyMessage& message) {
      if (name == "nothing") return false;
      if (name == "confirmed") return !is_confirmation(message);
      if (error == nullptr) return name != message.type().info->name;
      const auto* const one = message.get_if<msg::ErrorExt>();
      return one == nullptr || static_cast<std::uint8_t>(one->cmd_id) != asked_->id ||
             static_cast<std::int64_t>(one->error_code) != error->value;
    });
    if (!is_last) {
      EXPECT_EQ(found.size(), number);
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
      ASSERT_FALSE(found.empty());
      const AnyMessage& message = is_last ? found.back() : found.front();
      EXPECT_TRUE(holds_in(message, words[i])) << words[i] << " in " << to_string(message);
    }
    if (::testing::Test::HasFailure()) {
      for (std::size_t i = 0; i < std::min<std::size_t>(packets.size(), 5); ++i) {
        ADD_FAILURE() << "heard " << to_string(decoded(packets[i]));
      }
    }
  }

  std::unique_ptr<Host> host_{};
  std::string row_{};
  std::size_t ports_ = 1;
  Contexts contexts_{};
  const MessageInfo* asked_ = nullptr;
  std::map<std::string, AnyMessage> kept_{};
};

class Conversations : public ::testing::TestWithParam<Conversation> {};

TEST_P(Conversations, GoAsWritten) {
  Player player;
  for (const auto& [place, row] : GetParam().rows) {
    SCOPED_TRACE(place);
    ASSERT_NO_THROW(player.play(row));
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, Conversations, ::testing::ValuesIn(conversations()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace sbgc::test
