/// The output of `sbgc decode`.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "command/colors.hpp"
#include "command/standard_output.hpp"
#include "frames/decoded_frame.hpp"
#include "frames/frame_filter.hpp"
#include "frames/sample_writer.hpp"

namespace sbgc::tools {

/// The frames to print, and their format.
struct FrameOutputOptions {
  OutputFormat format = OutputFormat::text;
  bool real = false;                       ///< JSON lines also have the values in their units
  Secrets secrets{};                       ///< whether they are shown
  std::optional<Availability> versions{};  ///< of the firmware whose objections are wanted
  FrameFilter filter{};
};

/// Prints frames one after another. Text that is not about a frame goes to put_remark().
class FrameOutput {
 public:
  FrameOutput(const FrameOutputOptions& options, StandardOutput& out);

  bool is_text() const { return options_.format == OutputFormat::text; }

  /// Decodes a frame, and prints it unless the filter rejects it. Frames of a capture have a place.
  /// `heading` precedes the text of a frame. Returns true if it was printed.
  bool print(const Frame& frame, std::optional<Direction> direction, std::string_view heading,
             const CapturePlace* place = nullptr);
  /// Learns from a frame that is not to be printed what the decoding of later ones needs.
  void learn(const Frame& frame, Direction direction) {
    if (decoder_.decode(frame, direction).status) ++readable_;
    has_frames_ = true;
  }
  /// True if there were frames, but none of them can be decoded.
  bool is_unreadable() const { return has_frames_ && readable_ == 0; }
  /// Tells in the text format if none of the frames was selected.
  void end();
  /// Forgets the context of earlier frames.
  void begin_session() { decoder_ = new_decoder_; }

  /// Prints text, in the text format only.
  void put_remark(std::string_view text) {
    if (is_text()) out_.put(text);
  }

 private:
  FrameDecoder::Wanted wanted() const;
  void put_csv(const DecodedFrame& decoded, const CapturePlace* place);
  void begin_table(const DecodedFrame& decoded, SampleKey key);
  void require_same_columns(const DecodedFrame& decoded) const;

  FrameOutputOptions options_;
  StandardOutput& out_;
  Colors colors_{stdout};
  bool has_frames_ = false;
  bool has_printed_ = false;
  std::uint64_t readable_ = 0;  // the number of frames that can be decoded
  FrameDecoder new_decoder_;
  FrameDecoder decoder_ = new_decoder_;
  std::unique_ptr<SampleWriter> table_{};  // of the first message in CSV
  const MessageInfo* table_message_ = nullptr;
  std::map<std::string, std::string> table_units_{};  // of the columns, by path
};

}  // namespace sbgc::tools
