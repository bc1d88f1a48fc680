/// A decoded frame and its description.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/frame.hpp>
#include <sbgc/text_output.hpp>
#include <sbgc/visit.hpp>

#include "frames/value_rows.hpp"

namespace sbgc::tools {

/// An alternative message type for a body: the request decides, and it is unknown.
struct OtherReading {
  const MessageInfo* message{};
  const char* request = "";  ///< the request that leads to this message
  Rows rows{};               ///< if requested
};

/// The result of decoding one frame. The views are valid until the decoder decodes the next one.
struct DecodedFrame {
  Frame frame{};
  Direction direction{};
  bool is_guess{};                       ///< the direction is a guess: the size does not prove it
  const char* command = "";              ///< "" if the id is unknown
  const MessageInfo* message = nullptr;  ///< null if no message fits
  Status status{};
  std::string error_field{};  ///< the field of the error, if known
  std::string explanation{};  ///< of the error: the received and the required size
  /// The JSON of the message, if requested; for a truncated body, with zeros for the missing
  /// values.
  std::string_view fields{};
  std::string_view values{};  ///< the same with secrets
  /// The number of leading bytes whose values have arrived completely, in message order.
  std::size_t certain = max_body_size;
  Rows rows{};  ///< if requested; of a truncated body, the values in `certain` bytes
  std::vector<OtherReading> others{};
  bool is_for_firmware{};   ///< checked against the versions of a certain board
  std::string objection{};  ///< why a board with these versions does not know the message, or ""
  std::string note{};       ///< further information, or ""
  Secrets secrets{};        ///< whether the texts below show them

  /// True if the body cannot be decoded, but may hold a secret that must not be shown.
  bool hides_body() const;
};

/// The position of a frame in a capture file.
struct CapturePlace {
  double time{};  ///< in seconds since the start of the session
  int session{};
  double since_start{};  ///< in seconds since the start of the first session
};

/// Writes the object that `sbgc decode --format jsonl` prints. `more` are further members of it,
/// each preceded by a comma.
void put_json(TextOutput& out, const DecodedFrame& decoded, const CapturePlace* place = nullptr,
              std::string_view more = "");

/// Writes a body that cannot be decoded, in hex.
void put_body(TextOutput& out, const DecodedFrame& decoded);

/// Decodes frames in sequence and stores the context for later ones.
class FrameDecoder {
 public:
  /// The requested forms of a message.
  struct Wanted {
    bool json{};
    bool rows{};
    Secrets secrets{};  ///< whether they are shown
  };

  /// With `versions`, objects to everything that a board with these versions does not know.
  explicit FrameDecoder(Wanted wanted, std::optional<Availability> versions = std::nullopt)
      : wanted_(wanted), versions_(versions) {}

  /// Interprets later values as on a board with these versions.
  void learn(const Availability& versions) { seen_ = versions; }

  /// `direction` is the direction of the frame; if it is missing, the frame size decides, unless
  /// the body can only be decoded in the other direction.
  DecodedFrame decode(const Frame& frame, std::optional<Direction> direction);

 private:
  DecodedFrame decode_from(const Frame& frame, Direction direction);
  Status decode_body(std::span<const std::uint8_t> body, const Contexts& contexts,
                     DecodedFrame& result);
  /// Converts a decoded message to the requested forms.
  void take(const AnyMessage& message, DecodedFrame& result);
  /// Adds the alternatives for the body, if the request that decides it is unknown.
  void add_others(DecodedFrame& result);
  void add_other(const MessageType& type, DecodedFrame& result);
  /// Sets the explanation, and the rows of a truncated body.
  void describe_error(DecodedFrame& result);
  /// Sets the rows of a truncated body.
  void decode_arrived(DecodedFrame& result);
  /// Explains a size that no form has by the most probable cause.
  void explain_size(DecodedFrame& result);

  Wanted wanted_;
  std::optional<Availability> versions_;
  Availability seen_{};  // of the board that the last frame with versions is from
  Contexts contexts_{};
  std::string json_{};
  std::string with_secrets_{};
  ValueRows rows_{};
  std::deque<ValueRows> others_{};  // of the last frame
};

}  // namespace sbgc::tools
