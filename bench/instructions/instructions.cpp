// The work whose instructions are counted: see instructions.py, which runs this program in
// Valgrind. Prints "<case> <units>"; the costs follow as dumps with the names of the cases.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <span>

#include <valgrind/callgrind.h>

#include <sbgc/json.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/parameters.hpp>
#include <sbgc/meta/realtime.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>
#include <sbgc/validate.hpp>
#include <sbgc/visit.hpp>

#include "data.hpp"

namespace {

using sbgc::CrcTable;
using sbgc::Framing;
using namespace sbgc::bench;

constexpr std::size_t size = std::size_t{256} << 10;
constexpr std::size_t whole = size * 2;
constexpr std::size_t repetitions = 1000;

// The results of all work go here, so that the compiler keeps it.
volatile std::uint64_t seen = 0;

template <class T>
void keep(T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// Counts the instructions of `work`, which handles this number of bytes or messages.
template <class Work>
void count(const char* name, std::size_t units, Work&& work) {
  CALLGRIND_ZERO_STATS;
  CALLGRIND_TOGGLE_COLLECT;
  work();
  CALLGRIND_TOGGLE_COLLECT;
  CALLGRIND_DUMP_STATS_AT(name);
  std::printf("%s %zu\n", name, units);
}

template <class Parser, std::size_t chunk_size = whole, class Sink>
void feed(const Bytes& stream, Sink&& sink) {
  Parser parser;
  std::span<const std::uint8_t> rest(stream);
  while (rest.size() >= chunk_size) {
    parser.feed(rest.first(chunk_size), sink);
    rest = rest.subspan(chunk_size);
  }
  parser.feed(rest, sink);
  parser.flush(sink);
}

template <std::size_t chunk_size = whole, class Parser = sbgc::Parser>
void count_decoding(const char* name, const Bytes& stream) {
  count(name, stream.size(), [&] {
    sbgc::msg::RealtimeData4 message;
    keep(message);
    feed<Parser, chunk_size>(stream, [&](const sbgc::Frame& frame) {
      if (frame.id != static_cast<std::uint8_t>(sbgc::msg::RealtimeData4::command)) return;
      if (sbgc::decode(frame.body, message)) keep(message);
    });
  });
}

void count_visiting(const char* name, const Bytes& stream) {
  count(name, stream.size(), [&] {
    feed<sbgc::Parser>(stream, [](const sbgc::Frame& frame) {
      const auto status = sbgc::visit(frame, sbgc::Direction::from_board,
                                      [](const auto& message) { keep(message); });
      if (!status) fail("a message does not decode");
    });
  });
}

template <class M>
void count_validating(const char* name) {
  M message = typical<M>();
  keep(message);
  count(name, repetitions, [&] {
    for (std::size_t i = 0; i < repetitions; ++i) {
      keep(message);
      sbgc::validate(message, [](const sbgc::Violation&) { seen = seen + 1; });
    }
  });
}

template <class M>
void count_encoding(const char* name, M message) {
  std::array<std::uint8_t, sbgc::max_frame_size> frame{};
  keep(message);
  keep(frame);
  count(name, repetitions, [&] {
    for (std::size_t i = 0; i < repetitions; ++i) {
      keep(message);
      seen = seen + sbgc::encode_frame(message, frame).size;
      keep(frame);
    }
  });
}

void count_json() {
  auto message = typical<sbgc::msg::RealtimeData4>();
  std::array<char, 4096> text{};
  std::size_t length = 0;
  count("json/to_json", repetitions, [&] {
    for (std::size_t i = 0; i < repetitions; ++i) {
      keep(message);
      length = sbgc::to_json(message, text);
      keep(text);
    }
  });
  count("json/from_json", repetitions, [&] {
    for (std::size_t i = 0; i < repetitions; ++i) {
      if (!sbgc::from_json({text.data(), length}, message)) fail("JSON");
      keep(message);
    }
  });
}

void count_requests(const char* name) {
  static sbgc::Session session;
  std::array<std::uint8_t, sbgc::max_frame_size> answer{};
  const std::size_t answer_size = sbgc::encode_frame(sbgc::msg::GetAngles{}, answer).size;
  const auto sink = [](const sbgc::Event& event) {
    seen = seen + (event.outcome == sbgc::Outcome::answered ? 1 : 0);
  };
  sbgc::Instant now{};
  count(name, repetitions, [&] {
    for (std::size_t i = 0; i < repetitions; ++i) {
      now = now + sbgc::milliseconds(100);
      static_cast<void>(session.send(sbgc::msg::GetAnglesRequest{}));
      keep(session);
      static_cast<void>(session.poll(now, sink));
      session.feed(std::span(answer).first(answer_size), now, sink);
    }
  });
}

template <CrcTable table>
using ParserV2 = sbgc::BasicParser<sbgc::FrameFormats<table, Framing::v2>>;

}  // namespace

int main() {
  const Bytes clean = realtime_stream(size);
  const Bytes noisy = noise(size);
  const Bytes worst = worst_stream(size);
  const Bytes clean_v2 = realtime_stream(size, Framing::v2);
  const Bytes mixed = mixed_stream(size);
  const Bytes corrupt = corrupted(clean);
  CALLGRIND_START_INSTRUMENTATION;

  count_decoding("stream/clean", clean);
  count_decoding<64>("stream/clean_chunk64", clean);
  count_decoding<1>("stream/clean_byte", clean);
  count_decoding("stream/corrupt_1pct", corrupt);
  count_decoding("stream/noise", noisy);
  count_decoding<1>("stream/noise_byte", noisy);
  count_decoding("frames/worst", worst);
  count_decoding<64>("frames/worst_chunk64", worst);
  count_decoding<1>("frames/worst_byte", worst);
  // The table of bytes: that of slices is replaced by instructions that not every machine has.
  count_decoding<whole, ParserV2<CrcTable::bytes>>("stream_v2/clean_crc_bytes", clean_v2);
  count_decoding<whole, sbgc::ParserOfAll>("frames_all/clean_v1", clean);
  count_visiting("visit/realtime", clean);
  count_visiting("visit/mixed", mixed);
  count_validating<sbgc::msg::RealtimeData4>("realtime/validate");
  count_validating<sbgc::msg::ReadParams3>("params/validate");
  count_encoding("realtime/encode_frame", typical<sbgc::msg::RealtimeData4>());
  count_encoding("control/encode_frame", sbgc::msg::ControlExt{});
  count_json();
  count_requests("session/request_and_answer");
}
