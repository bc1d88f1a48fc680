// Fuzzes the reader of capture files. It never reads out of bounds, buffers at most one record,
// accounts for every byte of the file, and reports the same items for every chunk size. The first
// byte of the input is the chunk size. The remaining bytes build the file in steps of an opcode and
// its operands, because no mutation finds a valid checksum:
//   0..199:   append as many bytes as the opcode specifies
//   200..209: append a valid session header of the version in the next byte
//   210..249: append a valid record with the kind and time in the next two bytes; its data
//             has as many bytes as the opcode minus 210
//   250..254: remove the last bytes; the opcode minus 249 is their number
//   255:      append the remaining bytes
//
// The readers of captures see the same content: a replay delivers the bytes from the board, and
// `sbgc decode` finds the same frames, gaps and notes for every chunk size. A file that is no
// capture is read as raw bytes, and as hex text.

#include <system_error>
#include <variant>

#include <asio/io_context.hpp>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <sbgc/internal/crc32.hpp>
#include <sbgc/io/capture.hpp>
#include <sbgc/io/replay.hpp>
#include <sbgc/parser.hpp>

#include "frames/capture_frames.hpp"
#include "frames/input_guess.hpp"
#include "frames/pasted_text.hpp"
#include "frames/rejected_candidates.hpp"
#include "input.hpp"

namespace {

using sbgc::fuzz::require;

using Bytes = std::vector<std::uint8_t>;
namespace io = sbgc::io;

/// A comparable copy of an item.
struct Item {
  std::size_t type;
  std::uint64_t offset;
  std::uint64_t size;  // in the file
  std::int64_t time;
  int detail;
  Bytes bytes;

  bool operator==(const Item&) const = default;
};

Item item_of(const io::CaptureItem& item) {
  if (const auto* const session = std::get_if<io::CaptureSession>(&item)) {
    return {item.index(), session->offset, 24, session->start.time_since_epoch().count(), 0, {}};
  }
  if (const auto* const damage = std::get_if<io::CaptureDamage>(&item)) {
    require(!io::to_string(*damage).empty());
    return {item.index(), damage->offset, damage->size, 0, static_cast<int>(damage->reason), {}};
  }
  const auto& record = std::get<io::CaptureRecord>(item);
  require(record.time.count() >= 0);
  return {item.index(),
          record.offset,
          record.bytes.size() + 16,
          record.time.count(),
          static_cast<int>(record.kind),
          Bytes(record.bytes.begin(), record.bytes.end())};
}

std::vector<Item> read(std::span<const std::uint8_t> file, std::size_t piece) {
  std::vector<Item> result;
  io::CaptureParser parser;
  const auto take = [&] {
    while (const auto item = parser.next()) result.push_back(item_of(*item));
  };
  while (!file.empty()) {
    // On the heap and of exactly this size, so that a sanitizer detects a read out of bounds.
    const auto next = file.first(std::min(piece, file.size()));
    parser.feed(Bytes(next.begin(), next.end()));
    file = file.subspan(next.size());
    take();
  }
  parser.finish();
  take();
  require(!parser.next());
  return result;
}

void append_number(Bytes& out, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

/// Appends `bytes` and their checksum.
void append_sound(Bytes& out, const Bytes& bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
  append_number(out, sbgc::detail::crc32(bytes), 4);
}

Bytes make_file(std::span<const std::uint8_t> steps) {
  const auto take = [&steps](std::size_t count) {
    const auto taken = steps.first(std::min(count, steps.size()));
    steps = steps.subspan(taken.size());
    return taken;
  };
  const auto byte = [&]() -> std::uint8_t { return steps.empty() ? 0 : take(1)[0]; };
  Bytes file;
  while (!steps.empty()) {
    const std::uint8_t step = byte();
    if (step < 200 || step == 255) {
      const auto bytes = take(step == 255 ? steps.size() : step);
      file.insert(file.end(), bytes.begin(), bytes.end());
    } else if (step < 210) {
      Bytes header{0x89, 'S', 'B', 'G', 'C', 0x0D, 0x0A, 0x1A, byte()};
      header.resize(20);
      append_sound(file, header);
    } else if (step < 250) {
      Bytes record{0xA5, byte()};
      append_number(record, step - 210U, 2);
      append_number(record, byte(), 8);
      const auto content = take(step - 210U);
      record.insert(record.end(), content.begin(), content.end());
      append_sound(file, record);
    } else {
      file.resize(file.size() - std::min<std::size_t>(file.size(), step - 249U));
    }
  }
  return file;
}

using ByteSpan = std::span<const std::uint8_t>;

/// Calls `use` with the pieces of a file.
template <class Use>
void in_pieces(ByteSpan file, std::size_t piece, const Use& use) {
  for (; !file.empty(); file = file.subspan(std::min(piece, file.size()))) {
    use(file.first(std::min(piece, file.size())));
  }
}

/// Writes down what `sbgc decode` shows of a capture.
class Notes final : public sbgc::tools::CaptureListener {
 public:
  void on_session(const io::CaptureSession& session) override {
    text += fmt::format("session {}\n", session.offset);
  }
  void on_frame(sbgc::Direction, io::CaptureTime time, const sbgc::Frame& frame) override {
    text +=
        fmt::format("{} frame {} {} {}\n", time.count(), frame.offset, frame.id, frame.body.size());
  }
  void on_skipped(sbgc::Direction, io::CaptureTime, std::uint64_t size,
                  std::span<const sbgc::tools::RejectedCandidate> rejected) override {
    text += fmt::format("skipped {}\n", size);
    for (const auto& candidate : rejected) {
      require(!candidate.text.empty());
      text += fmt::format("{}: {}\n", candidate.offset, candidate.text);
    }
  }
  void on_note(io::CaptureTime, std::string_view note) override { text += note; }
  void on_damage(const io::CaptureDamage& damage) override { text += io::to_string(damage) + "\n"; }

  std::string text{};
};

std::string frames_of(ByteSpan file, std::size_t piece) {
  Notes notes;
  sbgc::tools::CaptureFrames frames(notes);
  in_pieces(file, piece, [&](ByteSpan bytes) { frames.feed(bytes); });
  frames.finish();
  return notes.text;
}

/// Returns the frames of raw bytes. Gaps are explained from the bytes that have arrived, so the
/// reasons depend on the pieces.
std::string raw_frames_of(ByteSpan file, std::size_t piece) {
  std::string text;
  std::uint64_t fed = 0;
  sbgc::ParserOfAll parser;
  sbgc::tools::GapExplainer explainer;
  const auto end_gap = [&](std::uint64_t until, std::uint64_t next) {
    for (const auto& candidate : explainer.end_gap(until, next)) {
      require(!candidate.text.empty() && candidate.offset < until);
    }
  };
  const auto take = [&](const sbgc::Frame& frame) {
    end_gap(frame.offset, frame.offset + sbgc::frame_size(frame.framing, frame.body.size()));
    text += fmt::format("frame {} {}\n", frame.offset, frame.id);
  };
  in_pieces(file, piece, [&](ByteSpan bytes) {
    fed += bytes.size();
    explainer.add(bytes);
    parser.feed(bytes, take);
    explainer.advance(fed - parser.waiting_bytes());
  });
  parser.flush(take);
  end_gap(file.size(), file.size());
  return text;
}

/// Returns the bytes that a text encodes.
std::optional<Bytes> bytes_of_text(ByteSpan file, const sbgc::tools::Reading& reading,
                                   std::size_t piece) {
  sbgc::tools::PastedText text(reading);
  Bytes bytes;
  std::optional<sbgc::tools::TextError> error;
  in_pieces(file, piece, [&](ByteSpan part) {
    if (!error) error = text.feed(part, bytes);
  });
  if (!error) error = text.finish(bytes);
  for (std::uint64_t offset = 0; offset < bytes.size(); ++offset) text.sender(offset);
  if (!error) return bytes;
  require(!to_text(reading, *error).empty());
  return std::nullopt;
}

/// Returns the bytes that a replay delivers.
Bytes replayed(ByteSpan file) {
  static const int descriptor = ::memfd_create("capture", 0);
  require(descriptor >= 0 && ::ftruncate(descriptor, 0) == 0);
  require(::pwrite(descriptor, file.data(), file.size(), 0) == static_cast<ssize_t>(file.size()));
  asio::io_context context;
  const auto opened = io::open_replay(
      context.get_executor(), fmt::format("/proc/self/fd/{}", descriptor), io::ReplayTiming::fast);
  require(opened.transport != nullptr);
  Bytes result;
  Bytes part(100);
  bool is_over = false;
  while (!is_over) {
    opened.transport->async_read(part, [&](std::error_code error, std::size_t size) {
      is_over = static_cast<bool>(error);
      result.insert(result.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(size));
    });
    context.restart();
    context.run();
  }
  return result;
}

void check_readers(const Bytes& file, const std::vector<Item>& items, std::size_t piece) {
  require(frames_of(file, piece) == frames_of(file, file.size() + 1));
  require(raw_frames_of(file, piece) == raw_frames_of(file, file.size() + 1));
  const sbgc::tools::ReadingChoice choice = sbgc::tools::choose_reading(file);
  for (const sbgc::tools::Reading& reading : {sbgc::tools::Reading{}, choice.reading}) {
    require(bytes_of_text(file, reading, piece) == bytes_of_text(file, reading, file.size() + 1));
  }
  require(choice.has_bytes || !sbgc::tools::is_text_of_bytes(file));
  static_cast<void>(sbgc::tools::guess_input(file, false));

  Bytes from_board;
  for (const Item& item : items) {
    if (item.type != 1 || item.detail != static_cast<int>(io::CaptureKind::from_board)) continue;
    from_board.insert(from_board.end(), item.bytes.begin(), item.bytes.end());
  }
  require(replayed(file) == (io::is_capture(file) ? from_board : file));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Bytes file = make_file(std::span(data, size).subspan(1));
  const std::vector<Item> items = read(file, std::size_t{data[0]} + 1);
  require(items == read(file, std::max<std::size_t>(file.size(), 1)));
  // The items cover the file without a gap.
  std::uint64_t end = 0;
  for (const Item& item : items) {
    require(item.offset == end && item.size > 0);
    end += item.size;
  }
  require(end == file.size());
  check_readers(file, items, std::size_t{data[0]} + 1);
  return 0;
}
