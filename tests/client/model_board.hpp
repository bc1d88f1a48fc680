/// A board in memory, as far as the tasks of the client need one: it answers one request at a time.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/messages.hpp>

namespace sbgc::test {

/// A message without its frame.
struct Packet {
  std::uint8_t id{};
  std::vector<std::uint8_t> body{};

  bool operator==(const Packet&) const = default;
};

using Packets = std::vector<Packet>;

template <class M>
Packet packet(const M& message) {
  Packet result{static_cast<std::uint8_t>(M::command), std::vector<std::uint8_t>(255)};
  result.body.resize(encode(message, result.body).size);
  return result;
}

/// The message in a packet. Precondition: it is one.
template <class M>
M message(const Packet& packet) {
  M result{};
  static_cast<void>(decode(std::span(packet.body), result));
  return result;
}

template <class M>
bool is(const Packet& packet) {
  return packet.id == static_cast<std::uint8_t>(M::command);
}

class ModelBoard {
 public:
  ModelBoard();

  /// What the board sends for a request. Thread-safe only if its owner is.
  Packets answer(const Packet& request);

  BoardInfo info{};
  BoardInfo3 details{};

  // Settings
  std::array<ReadParams3, 5> params{};
  std::array<ReadParamsExt, 5> params_ext{};
  std::array<ReadParamsExt2, 5> params_ext2{};
  ReadProfileNames names{};
  ReadAdjVarsCfg adjustable{};
  ReadExternalData external{};

  // Memory
  std::vector<std::uint8_t> eeprom = std::vector<std::uint8_t>(32768);
  std::map<std::uint16_t, std::vector<std::uint8_t>> files{};

  // Motion: each look at the angles moves the camera a step.
  Axes<Angle14> angles{};
  Axes<Angle14> targets{};
  Axes<ControlSpeed> speeds{};
  Axes<bool> controlled{};
  std::int16_t step = 200;
  bool is_stuck = false;

  std::map<VariableId, std::int32_t> variables{};
  unsigned saved = 0;

  // Calibration: it starts with a confirmation, each request for information is a step of it, and
  // behind the last one it is confirmed again.
  unsigned calibration_steps = 3;
  unsigned steps_left = 0;
  std::uint8_t calibrates = 0;  ///< id of the command

  /// All requests, in order.
  Packets log{};
  /// Whether a request is lost on its way.
  std::function<bool(const Packet&)> is_lost{};
  /// Whether the answer to a request that is carried out is lost on its way.
  std::function<bool(const Packet&)> is_answer_lost{};
  /// Changes the answers before they are sent.
  std::function<void(Packets&)> tamper{};
  /// Changes the board after a request has been carried out.
  std::function<void(const Packet&)> after{};

  template <class M>
  std::size_t count() const {
    std::size_t result = 0;
    for (const Packet& one : log) result += is<M>(one) ? 1U : 0U;
    return result;
  }

 private:
  Packets carry_out(const Packet& request);
  Packets read_file(const ReadFileRequest& request) const;
  Packets write_file(const WriteFile& request);
  Packets control(const Axes<ControlMode>& modes, const Axes<ControlAxis>& axes);
  Packet look();
};

}  // namespace sbgc::test
