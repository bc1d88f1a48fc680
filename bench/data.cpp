#include "data.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include <sbgc/frame.hpp>
#include <sbgc/messages/realtime.hpp>

namespace sbgc::bench {

namespace {

constexpr auto realtime_id = static_cast<std::uint8_t>(msg::RealtimeData4::command);
constexpr std::size_t realtime_size = msg::RealtimeData4::min_size;

struct TypicalBody {
  std::uint8_t id{};
  Bytes body{};
};

Bytes from_hex(const std::string& text) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(text.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

/// Reads the bodies with typical values that the board sends, from the test vectors.
std::vector<TypicalBody> read_typical_bodies() {
  std::vector<TypicalBody> bodies;
  for (const auto& entry : std::filesystem::directory_iterator(SBGC_VECTORS)) {
    std::ifstream file(entry.path());
    if (!file) fail("a file of test vectors cannot be read");
    for (std::string line; std::getline(file, line);) {
      if (line.find("typical values") == std::string::npos) continue;  // parsing takes long
      const auto vector = nlohmann::json::parse(line);
      if (vector.at("why") != "typical values" || vector.at("direction") == "to_board") continue;
      bodies.push_back({vector.at("id"), from_hex(vector.at("hex"))});
    }
  }
  return bodies;
}

const std::vector<TypicalBody>& typical_bodies() {
  static const std::vector<TypicalBody> bodies = read_typical_bodies();
  return bodies;
}

}  // namespace

void fail(const char* what) {
  std::fprintf(stderr, "benchmark: wrong data: %s\n", what);
  std::exit(1);
}

Bytes realtime_stream(std::size_t size, Framing framing) {
  std::mt19937 random(1);
  Bytes bytes;
  bytes.reserve(size + max_frame_size);
  std::array<std::uint8_t, realtime_size> body{};
  std::array<std::uint8_t, max_frame_size> frame{};
  while (bytes.size() < size) {
    fill_randomly(body, random);
    const std::size_t length = write_frame(framing, realtime_id, body, frame).size;
    bytes.insert(bytes.end(), frame.data(), frame.data() + length);
  }
  return bytes;
}

Bytes mixed_stream(std::size_t size) {
  using Command = msg::CommandFromBoard;
  constexpr std::array commands{
      Command::realtime_data_3,  Command::realtime_data_4,    Command::get_angles,
      Command::get_angles_ext,   Command::board_info,         Command::board_info_3,
      Command::read_params_3,    Command::read_params_ext,    Command::read_params_ext2,
      Command::read_params_ext3, Command::read_profile_names, Command::read_adj_vars_cfg,
      Command::set_adj_vars_val, Command::calib_info,         Command::module_list,
      Command::confirm,          Command::ahrs_helper,        Command::event,
      Command::read_rc_inputs,   Command::read_state_vars};
  std::vector<TypicalBody> kinds;
  for (const Command command : commands) {
    const auto id = static_cast<std::uint8_t>(command);
    kinds.push_back({id, typical_body(id, 0)});
  }
  std::mt19937 random(5);
  Bytes bytes;
  bytes.reserve(size + max_frame_size);
  std::array<std::uint8_t, max_frame_size> frame{};
  while (bytes.size() < size) {
    const TypicalBody& one = kinds[random() % kinds.size()];
    const std::size_t length = write_frame(one.id, one.body, frame).size;
    bytes.insert(bytes.end(), frame.data(), frame.data() + length);
  }
  return bytes;
}

Bytes corrupted(Bytes bytes) {
  std::mt19937 random(2);
  for (std::uint8_t& byte : bytes) {
    if (random() % 100 == 0) byte = static_cast<std::uint8_t>(byte + 1 + random() % 255);
  }
  return bytes;
}

Bytes noise(std::size_t size) {
  std::mt19937 random(3);
  Bytes bytes(size);
  fill_randomly(bytes, random);
  return bytes;
}

Bytes worst_stream(std::size_t size) {
  // The header checksum of each is the start byte of the next.
  constexpr std::array<std::uint8_t, 3> header{0x3E, 0x3F, 0xFF};
  Bytes bytes;
  bytes.reserve(size + header.size());
  while (bytes.size() < size) bytes.insert(bytes.end(), header.begin(), header.end());
  return bytes;
}

const Bytes& realtime() {
  static const Bytes bytes = realtime_stream();
  return bytes;
}

const Bytes& realtime_v2() {
  static const Bytes bytes = realtime_stream(stream_size, Framing::v2);
  return bytes;
}

const Bytes& mixed() {
  static const Bytes bytes = mixed_stream();
  return bytes;
}

const Bytes& corrupted_realtime() {
  static const Bytes bytes = corrupted(realtime());
  return bytes;
}

const Bytes& corrupted_realtime_v2() {
  static const Bytes bytes = corrupted(realtime_v2());
  return bytes;
}

const Bytes& noise_stream() {
  static const Bytes bytes = noise();
  return bytes;
}

const Bytes& worst() {
  static const Bytes bytes = worst_stream();
  return bytes;
}

Bytes typical_body(std::uint8_t id, std::size_t size) {
  for (const TypicalBody& one : typical_bodies()) {
    if (one.id == id && one.body.size() >= size) return one.body;
  }
  fail("a message has no typical body");
}

}  // namespace sbgc::bench
