#include "model_board.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>

#include <sbgc/meta.hpp>

namespace sbgc::test {
namespace {

/// A confirmation, with the data that this command has.
template <class M>
Packet confirmation(std::vector<std::uint8_t> data = {}) {
  Packet result{static_cast<std::uint8_t>(CommandId::confirm),
                {static_cast<std::uint8_t>(M::command)}};
  result.body.insert(result.body.end(), data.begin(), data.end());
  return result;
}

/// Fills a body with bytes that are all different from their neighbours and from another seed's.
template <class M>
void fill(M& out, std::size_t size, std::uint8_t seed) {
  std::vector<std::uint8_t> body(size);
  std::iota(body.begin(), body.end(), seed);
  static_cast<void>(decode(std::span(body), out));
}

}  // namespace

ModelBoard::ModelBoard() {
  info.board_ver = BoardVersion(30);
  info.firmware_ver = FirmwareVersion(2590);
  fill(details, BoardInfo3::min_size, 7);
  details.eeprom_size = LongByteCount(static_cast<std::uint32_t>(eeprom.size()));
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    // Later firmware sends more than is documented.
    fill(params[profile], ReadParams3::min_size + 5, static_cast<std::uint8_t>(profile * 40));
    fill(params_ext[profile], ReadParamsExt::min_size, static_cast<std::uint8_t>(profile * 41));
    fill(params_ext2[profile], ReadParamsExt2::min_size, static_cast<std::uint8_t>(profile * 42));
    params[profile].profile_id = profile;
    params_ext[profile].profile_id = profile;
    params_ext2[profile].profile_id = profile;
    params[profile].cur_imu = SelectedImu::main;
    params[profile].cur_profile_id = 0;
  }
  fill(adjustable, ReadAdjVarsCfg::min_size, 3);
  fill(external, ReadExternalData::min_size, 99);
  static_cast<void>(names.profile_name[0].assign(std::string_view("Handheld")));
  for (std::size_t i = 0; i < eeprom.size(); ++i) eeprom[i] = static_cast<std::uint8_t>(i * 7 / 3);
}

Packets ModelBoard::answer(const Packet& request) {
  log.push_back(request);
  if (is_lost && is_lost(request)) return {};
  Packets result = carry_out(request);
  if (tamper) tamper(result);
  if (after) after(request);
  if (is_answer_lost && is_answer_lost(request)) return {};
  return result;
}

// NOLINTNEXTLINE(readability-function-size): a table
Packets ModelBoard::carry_out(const Packet& request) {
  const auto of_profile = [&](auto& settings) -> Packets {
    const std::size_t profile = request.body.at(0);
    return profile < 5 ? Packets{packet(settings[profile])} : Packets{};
  };
  const auto store = [&]<class M>(Type<M>, auto& settings) -> Packets {
    const M stored = message<M>(request);
    settings = stored;
    return {confirmation<M>()};
  };
  if (is<BoardInfoRequest>(request)) return {packet(info)};
  if (is<BoardInfo3Request>(request)) return {packet(details)};
  if (is<ReadParams3Request>(request)) return of_profile(params);
  if (is<ReadParamsExtRequest>(request)) return of_profile(params_ext);
  if (is<ReadParamsExt2Request>(request)) return of_profile(params_ext2);
  if (is<ReadProfileNamesRequest>(request)) return {packet(names)};
  if (is<ReadAdjVarsCfgRequest>(request)) return {packet(adjustable)};
  if (is<ReadExternalDataRequest>(request)) return {packet(external)};
  if (is<WriteParams3>(request)) {
    return store(Type<WriteParams3>{}, params.at(request.body.at(0)));
  }
  if (is<WriteParamsExt>(request)) {
    return store(Type<WriteParamsExt>{}, params_ext.at(request.body.at(0)));
  }
  if (is<WriteParamsExt2>(request)) {
    return store(Type<WriteParamsExt2>{}, params_ext2.at(request.body.at(0)));
  }
  if (is<WriteProfileNames>(request)) return store(Type<WriteProfileNames>{}, names);
  if (is<WriteAdjVarsCfg>(request)) return store(Type<WriteAdjVarsCfg>{}, adjustable);
  if (is<WriteExternalData>(request)) return store(Type<WriteExternalData>{}, external);
  if (is<EepromReadRequest>(request)) {
    const auto wanted = message<EepromReadRequest>(request);
    EepromRead result;
    result.addr = wanted.addr;
    static_cast<void>(result.data.resize(wanted.size.raw()));
    std::copy_n(eeprom.begin() + wanted.addr, wanted.size.raw(), result.data.begin());
    return {packet(result)};
  }
  if (is<EepromWrite>(request)) {
    const auto wanted = message<EepromWrite>(request);
    std::ranges::copy(wanted.data, eeprom.begin() + wanted.addr);
    return {confirmation<EepromWrite>({request.body.begin(), request.body.begin() + 4})};
  }
  if (is<ReadFileRequest>(request)) return read_file(message<ReadFileRequest>(request));
  if (is<WriteFile>(request)) return write_file(message<WriteFile>(request));
  if (is<FsClearAll>(request)) {
    files.clear();
    return {confirmation<FsClearAll>({0})};
  }
  if (is<GetAdjVarsVal>(request)) {
    SetAdjVarsVal result;
    for (const VariableId id : message<GetAdjVarsVal>(request).param_id) {
      result.params.push_back({id, variables[id]});
    }
    return {packet(result)};
  }
  if (is<SetAdjVarsVal>(request)) {
    for (const AdjVarValue& value : message<SetAdjVarsVal>(request).params) {
      variables[value.param_id] = value.param_value;
    }
    return {confirmation<SetAdjVarsVal>()};
  }
  if (is<SaveParams3>(request)) {
    ++saved;
    return {confirmation<SaveParams3>()};
  }
  if (is<GetAnglesRequest>(request)) return {look()};
  if (is<Control>(request) && request.body.size() == Control::max_size) {
    const auto command = message<Control>(request);
    return control({command.control_mode, command.control_mode, command.control_mode},
                   command.axes);
  }
  if (is<ControlExt>(request)) {
    const auto command = message<ControlExt>(request);
    return control(command.control_mode, command.axes);
  }
  if (is<CalibGyro>(request) || is<CalibAcc>(request)) {
    calibrates = request.id;
    steps_left = calibration_steps;
    return {{static_cast<std::uint8_t>(CommandId::confirm), {request.id}}};
  }
  if (is<CalibInfoRequest>(request)) {
    CalibInfo state;
    state.imu_type = message<CalibInfoRequest>(request).imu_type;
    Packets result;
    if (steps_left > 0 && --steps_left == 0) {
      result.push_back({static_cast<std::uint8_t>(CommandId::confirm), {calibrates}});
    }
    const unsigned done = 100 * (calibration_steps - steps_left) / std::max(calibration_steps, 1U);
    state.progress = Percent(static_cast<std::uint8_t>(done));
    result.insert(result.begin(), packet(state));
    return result;
  }
  return {};
}

Packets ModelBoard::read_file(const ReadFileRequest& request) const {
  const auto found = files.find(request.file_id);
  if (found == files.end()) return {packet(ReadFileError{FileError::file_not_found})};
  const auto& content = found->second;
  ReadFile result;
  result.file_size = ByteCount(static_cast<std::uint16_t>(content.size()));
  result.page_offset = request.page_offset;
  const std::size_t first = std::min(content.size(), std::size_t{request.page_offset.raw()} * 64);
  const std::size_t size =
      std::min(content.size() - first, std::size_t{request.max_data_size.raw()});
  static_cast<void>(result.data.resize(size));
  std::copy_n(content.begin() + static_cast<std::ptrdiff_t>(first), size, result.data.begin());
  return {packet(result)};
}

Packets ModelBoard::write_file(const WriteFile& request) {
  const auto end = [](FileError error) {
    return Packets{confirmation<WriteFile>({static_cast<std::uint8_t>(error)})};
  };
  if (request.data.empty()) {
    return end(files.erase(request.file_id) != 0 ? FileError::no_error : FileError::file_not_found);
  }
  auto& content = files[request.file_id];
  content.resize(request.file_size.raw());
  const std::size_t first = std::size_t{request.page_offset.raw()} * 64;
  if (first + request.data.size() > content.size()) return end(FileError::file_size);
  std::ranges::copy(request.data, content.begin() + static_cast<std::ptrdiff_t>(first));
  return end(FileError::no_error);
}

Packets ModelBoard::control(const Axes<ControlMode>& modes, const Axes<ControlAxis>& axes) {
  for (std::size_t i = 0; i < 3; ++i) {
    controlled[i] = modes[i].mode() != ControlModeKind::no_control;
    if (modes[i].mode() == ControlModeKind::angle) {
      targets[i] = axes[i].angle;
      speeds[i] = targets[i] == angles[i] || is_stuck ? ControlSpeed(0) : ControlSpeed(100);
    } else if (modes[i].mode() == ControlModeKind::speed) {
      speeds[i] = axes[i].speed;
      targets[i] = angles[i];
    }
  }
  return {};  // a board need not confirm it
}

Packet ModelBoard::look() {
  GetAngles result;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_stuck) {
      const int way = static_cast<std::int16_t>(targets[i].raw() - angles[i].raw());
      angles[i] =
          Angle14(static_cast<std::int16_t>(angles[i].raw() + std::clamp<int>(way, -step, step)));
      if (way != 0 && angles[i] == targets[i]) speeds[i] = ControlSpeed(0);
    }
    result.axes[i] = {angles[i], targets[i], speeds[i]};
  }
  return packet(result);
}

}  // namespace sbgc::test
