// The content of CMD_REALTIME_DATA_4 with this library and with general serializers. Each frames
// its messages as its users do: protobuf and nanopb with a length in front, FlatBuffers with a
// size. None of these can find its way back after an error or detects a wrong byte; this protocol
// can.
//
// One iteration reads or writes 10,000 messages. All read the same three angles of a decoded
// message.

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <flatbuffers/flatbuffers.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/util/delimited_message_util.h>
#include <nlohmann/json.hpp>
#include <pb_decode.h>
#include <pb_encode.h>

#include <sbgc/message.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/parser.hpp>

#include "data.hpp"
#include "flatbuffers/telemetry_generated.h"
#include "nanopb/telemetry.pb.h"
#include "protobuf/telemetry.pb.h"

namespace sbgc::bench {
namespace {

namespace pb = google::protobuf;

constexpr int messages = 10'000;
constexpr std::size_t room = 512;

// The same values for all

/// The typical values of the test vectors.
const nlohmann::json& values() {
  static const nlohmann::json fields = [] {
    std::ifstream file(SBGC_VECTORS "/realtime.jsonl");
    for (std::string line; std::getline(file, line);) {
      auto vector = nlohmann::json::parse(line);
      if (vector.at("message") == "RealtimeData4") return vector.at("fields");
    }
    fail("the vectors have no RealtimeData4");
  }();
  return fields;
}

void fill(pb::Message& message, const nlohmann::json& from) {
  const pb::Descriptor& type = *message.GetDescriptor();
  const pb::Reflection& reflection = *message.GetReflection();
  for (int i = 0; i < type.field_count(); ++i) {
    const pb::FieldDescriptor* const field = type.field(i);
    const nlohmann::json& value = from.at(field->name());
    switch (field->cpp_type()) {
      case pb::FieldDescriptor::CPPTYPE_MESSAGE:
        fill(*reflection.MutableMessage(&message, field), value);
        break;
      case pb::FieldDescriptor::CPPTYPE_INT32: reflection.SetInt32(&message, field, value); break;
      default: reflection.SetUInt32(&message, field, value); break;
    }
  }
}

peers::Telemetry protobuf_message() {
  peers::Telemetry message;
  fill(message, values());
  return message;
}

/// nanopb has the same encoding as protobuf.
peers_Telemetry nanopb_message() {
  const std::string bytes = protobuf_message().SerializeAsString();
  peers_Telemetry message = peers_Telemetry_init_zero;
  auto stream =
      pb_istream_from_buffer(reinterpret_cast<const pb_byte_t*>(bytes.data()), bytes.size());
  if (!pb_decode(&stream, peers_Telemetry_fields, &message)) fail("nanopb");
  return message;
}

peers::flat::Axes axes_of(const char* name) {
  const nlohmann::json& axes = values().at(name);
  return {axes.at("roll"), axes.at("pitch"), axes.at("yaw")};
}

peers::flat::Sensors sensors_of(const char* axis) {
  const nlohmann::json& sensors = values().at("axes").at(axis);
  return {sensors.at("acc_data"), sensors.at("gyro_data")};
}

peers::flat::TelemetryT flatbuffers_message() {
  using peers::flat::Axes;
  const nlohmann::json& v = values();
  const nlohmann::json& power = v.at("motor_power");
  const auto axes = [](const char* name) { return std::make_unique<Axes>(axes_of(name)); };
  peers::flat::TelemetryT m;
  m.axes = std::make_unique<peers::flat::AxesSensors>(sensors_of("roll"), sensors_of("pitch"),
                                                      sensors_of("yaw"));
  m.serial_error_cnt = v.at("serial_error_cnt");
  m.system_error = v.at("system_error");
  m.system_sub_error = v.at("system_sub_error");
  m.rc = axes("rc");
  m.rc_cmd = v.at("rc_cmd");
  m.ext_fc_roll = v.at("ext_fc_roll");
  m.ext_fc_pitch = v.at("ext_fc_pitch");
  m.angle = axes("angle");
  m.frame_imu_angle = axes("frame_imu_angle");
  m.rc_angle = axes("rc_angle");
  m.cycle_time = v.at("cycle_time");
  m.i2c_error_count = v.at("i2c_error_count");
  m.error_code = v.at("error_code");
  m.bat_level = v.at("bat_level");
  m.other_flags = v.at("other_flags");
  m.cur_imu = v.at("cur_imu");
  m.cur_profile = v.at("cur_profile");
  m.motor_power = std::make_unique<peers::flat::AxisBytes>(power.at("roll"), power.at("pitch"),
                                                           power.at("yaw"));
  m.rotor_angle = axes("rotor_angle");
  m.balance_error = axes("balance_error");
  m.current = v.at("current");
  m.mag_data = axes("mag_data");
  m.imu_temperature = v.at("imu_temperature");
  m.frame_imu_temperature = v.at("frame_imu_temperature");
  m.imu_g_err = v.at("imu_g_err");
  m.imu_h_err = v.at("imu_h_err");
  m.motor_out = axes("motor_out");
  m.calib_mode = v.at("calib_mode");
  m.can_imu_ext_sens_err = v.at("can_imu_ext_sens_err");
  m.actual_angle = axes("actual_angle");
  m.system_state_flags = v.at("system_state_flags");
  return m;
}

/// Repeats the bytes of one message.
Bytes repeated(const void* data, std::size_t size) {
  const auto* const bytes = static_cast<const std::uint8_t*>(data);
  Bytes stream;
  stream.reserve(size * messages);
  for (int i = 0; i < messages; ++i) stream.insert(stream.end(), bytes, bytes + size);
  return stream;
}

void count(benchmark::State& state, std::size_t size, std::int64_t angles) {
  const auto& expected = values().at("angle");
  const std::int64_t each = expected.at("roll").get<int>() + expected.at("pitch").get<int>() +
                            expected.at("yaw").get<int>();
  if (angles != each * messages) state.SkipWithError("wrong angles");
  state.SetItemsProcessed(state.iterations() * messages);
  state.counters["bytes"] = static_cast<double>(size);
}

void count(benchmark::State& state, std::size_t size) {
  state.SetItemsProcessed(state.iterations() * messages);
  state.counters["bytes"] = static_cast<double>(size);
}

// Baseline

void copy_frames(benchmark::State& state) {
  constexpr std::size_t size = sbgc::frame_size(sbgc::msg::RealtimeData4::min_size);
  const Bytes from(size * messages, 1);
  Bytes to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
  count(state, size);
}

// This library

void sbgc_read(benchmark::State& state) {
  const auto message = typical<sbgc::msg::RealtimeData4>();
  std::array<std::uint8_t, sbgc::max_frame_size> frame{};
  const std::size_t size = sbgc::encode_frame(message, frame).size;
  const Bytes stream = repeated(frame.data(), size);
  std::int64_t angles = 0;
  sbgc::msg::RealtimeData4 read;
  for (auto _ : state) {
    angles = 0;
    sbgc::Parser parser;
    parser.feed(stream, [&](const sbgc::Frame& found) {
      if (!sbgc::decode(found.body, read)) return;
      benchmark::DoNotOptimize(&read);
      benchmark::ClobberMemory();
      angles += read.angle.roll.raw() + read.angle.pitch.raw() + read.angle.yaw.raw();
    });
  }
  count(state, size, angles);
}

void sbgc_write(benchmark::State& state) {
  auto message = typical<sbgc::msg::RealtimeData4>();
  std::array<std::uint8_t, sbgc::max_frame_size> frame{};
  std::size_t size = 0;
  benchmark::DoNotOptimize(&message);
  benchmark::DoNotOptimize(frame.data());
  for (auto _ : state) {
    for (int i = 0; i < messages; ++i) {
      benchmark::ClobberMemory();
      size = sbgc::encode_frame(message, frame).size;
      benchmark::ClobberMemory();
    }
  }
  count(state, size);
}

// protobuf

void protobuf_read(benchmark::State& state) {
  const peers::Telemetry message = protobuf_message();
  std::string one;
  {
    pb::io::StringOutputStream output(&one);
    if (!pb::util::SerializeDelimitedToZeroCopyStream(message, &output)) fail("protobuf");
  }
  const Bytes stream = repeated(one.data(), one.size());
  std::int64_t angles = 0;
  peers::Telemetry read;
  for (auto _ : state) {
    angles = 0;
    pb::io::CodedInputStream input(stream.data(), static_cast<int>(stream.size()));
    std::uint32_t size = 0;
    while (input.ReadVarint32(&size)) {
      const auto limit = input.PushLimit(static_cast<int>(size));
      read.Clear();  // keeps the memory of the last message, as advised
      if (!read.MergeFromCodedStream(&input)) state.SkipWithError("protobuf");
      input.PopLimit(limit);
      benchmark::DoNotOptimize(&read);
      angles += read.angle().roll() + read.angle().pitch() + read.angle().yaw();
    }
  }
  count(state, one.size(), angles);
}

void protobuf_write(benchmark::State& state) {
  peers::Telemetry message = protobuf_message();
  std::array<std::uint8_t, room> frame{};
  std::size_t size = 0;
  benchmark::DoNotOptimize(&message);
  benchmark::DoNotOptimize(frame.data());
  for (auto _ : state) {
    for (int i = 0; i < messages; ++i) {
      benchmark::ClobberMemory();
      const std::size_t body = message.ByteSizeLong();
      std::uint8_t* const begin = pb::io::CodedOutputStream::WriteVarint32ToArray(
          static_cast<std::uint32_t>(body), frame.data());
      size =
          static_cast<std::size_t>(message.SerializeWithCachedSizesToArray(begin) - frame.data());
      benchmark::ClobberMemory();
    }
  }
  count(state, size);
}

// FlatBuffers

Bytes flatbuffers_bytes() {
  flatbuffers::FlatBufferBuilder builder(room);
  const auto message = flatbuffers_message();
  builder.FinishSizePrefixed(peers::flat::Telemetry::Pack(builder, &message));
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

/// Verifies each buffer, as is necessary for bytes from outside, and calls `use`.
template <class Use>
void for_each_buffer(const Bytes& stream, std::size_t size, Use&& use) {
  for (std::size_t at = 0; at < stream.size(); at += size) {
    flatbuffers::Verifier verifier(stream.data() + at, size);
    if (!verifier.VerifySizePrefixedBuffer<peers::flat::Telemetry>(nullptr)) continue;
    use(*flatbuffers::GetSizePrefixedRoot<peers::flat::Telemetry>(stream.data() + at));
  }
}

void flatbuffers_read(benchmark::State& state) {
  const Bytes one = flatbuffers_bytes();
  const Bytes stream = repeated(one.data(), one.size());
  std::int64_t angles = 0;
  for (auto _ : state) {
    angles = 0;
    for_each_buffer(stream, one.size(), [&](const peers::flat::Telemetry& read) {
      angles += read.angle()->roll() + read.angle()->pitch() + read.angle()->yaw();
    });
    benchmark::DoNotOptimize(angles);
  }
  count(state, one.size(), angles);
}

/// Also copies all values into a struct, as the others do.
void flatbuffers_unpack(benchmark::State& state) {
  const Bytes one = flatbuffers_bytes();
  const Bytes stream = repeated(one.data(), one.size());
  std::int64_t angles = 0;
  peers::flat::TelemetryT read;
  for (auto _ : state) {
    angles = 0;
    for_each_buffer(stream, one.size(), [&](const peers::flat::Telemetry& table) {
      table.UnPackTo(&read);
      benchmark::DoNotOptimize(&read);
      angles += read.angle->roll() + read.angle->pitch() + read.angle->yaw();
    });
  }
  count(state, one.size(), angles);
}

void flatbuffers_write(benchmark::State& state) {
  auto message = flatbuffers_message();
  flatbuffers::FlatBufferBuilder builder(room);
  std::size_t size = 0;
  benchmark::DoNotOptimize(&message);
  for (auto _ : state) {
    for (int i = 0; i < messages; ++i) {
      benchmark::ClobberMemory();
      builder.Clear();
      builder.FinishSizePrefixed(peers::flat::Telemetry::Pack(builder, &message));
      size = builder.GetSize();
      benchmark::ClobberMemory();
    }
  }
  count(state, size);
}

// nanopb

void nanopb_read(benchmark::State& state) {
  peers_Telemetry message = nanopb_message();
  std::array<std::uint8_t, room> frame{};
  auto output = pb_ostream_from_buffer(frame.data(), frame.size());
  if (!pb_encode_delimited(&output, peers_Telemetry_fields, &message)) fail("nanopb");
  const Bytes stream = repeated(frame.data(), output.bytes_written);
  std::int64_t angles = 0;
  peers_Telemetry read = peers_Telemetry_init_zero;
  for (auto _ : state) {
    angles = 0;
    auto input = pb_istream_from_buffer(stream.data(), stream.size());
    while (input.bytes_left != 0) {
      if (!pb_decode_delimited(&input, peers_Telemetry_fields, &read)) break;
      benchmark::DoNotOptimize(&read);
      angles += read.angle.roll + read.angle.pitch + read.angle.yaw;
    }
  }
  count(state, output.bytes_written, angles);
}

void nanopb_write(benchmark::State& state) {
  peers_Telemetry message = nanopb_message();
  std::array<std::uint8_t, room> frame{};
  std::size_t size = 0;
  benchmark::DoNotOptimize(&message);
  benchmark::DoNotOptimize(frame.data());
  for (auto _ : state) {
    for (int i = 0; i < messages; ++i) {
      benchmark::ClobberMemory();
      auto output = pb_ostream_from_buffer(frame.data(), frame.size());
      if (!pb_encode_delimited(&output, peers_Telemetry_fields, &message)) {
        state.SkipWithError("nanopb");
      }
      size = output.bytes_written;
      benchmark::ClobberMemory();
    }
  }
  count(state, size);
}

BENCHMARK(copy_frames)->Name("peers/memcpy");
BENCHMARK(sbgc_read)->Name("peers/sbgc_read");
BENCHMARK(flatbuffers_read)->Name("peers/flatbuffers_read");
BENCHMARK(flatbuffers_unpack)->Name("peers/flatbuffers_unpack");
BENCHMARK(protobuf_read)->Name("peers/protobuf_read");
BENCHMARK(nanopb_read)->Name("peers/nanopb_read");
BENCHMARK(sbgc_write)->Name("peers/sbgc_write");
BENCHMARK(flatbuffers_write)->Name("peers/flatbuffers_write");
BENCHMARK(protobuf_write)->Name("peers/protobuf_write");
BENCHMARK(nanopb_write)->Name("peers/nanopb_write");

}  // namespace
}  // namespace sbgc::bench
