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

/// Another message that a body may be: the request decides, and nobody has seen it.
struct OtherReading {
  const MessageInfo* message{};
  const char* request = "";  ///< after which the body is this message
  Rows rows{};               ///< if wanted
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
  std::string explanation{};  ///< of the error: what came, and what the message needs
  /// The JSON of the message, if wanted; of a body that is too short, with zeros for what is
  /// missing.
  std::string_view fields{};
  std::string_view values{};  ///< the same with secrets
  /// The number of leading bytes whose values have arrived whole, and where the message has them.
  std::size_t certain = max_body_size;
  Rows rows{};  ///< if wanted; of a body that is too short, the values in `certain` bytes
  std::vector<OtherReading> others{};
  bool is_for_firmware{};   ///< checked against the versions of a certain board
  std::string objection{};  ///< why a board with these versions does not know the message, or ""
  std::string note{};       ///< what else there is to know, or ""
  Secrets secrets{};        ///< whether the texts below show them

  /// True if the body cannot be decoded, but seems to hold a secret that is not to be shown.
  bool hides_body() const;
};

/// The place of a frame in a capture file.
struct CapturePlace {
  double time{};  ///< in seconds since the start of the session
  int session{};
  double since_start{};  ///< in seconds since the start of the first session
};

/// Writes the object that `sbgc decode --format jsonl` prints. `more` are further members of it,
/// with commas before them.
void put_json(TextOutput& out, const DecodedFrame& decoded, const CapturePlace* place = nullptr,
              std::string_view more = "");

/// Writes a body that cannot be decoded, in hex.
void put_body(TextOutput& out, const DecodedFrame& decoded);

/// Decodes frames in sequence and stores the context for later ones.
class FrameDecoder {
 public:
  /// The forms of a message that are wanted.
  struct Wanted {
    bool json{};
    bool rows{};
    Secrets secrets{};  ///< whether they are shown
  };

  /// With `versions`, objects to what a board with these versions does not know.
  explicit FrameDecoder(Wanted wanted, std::optional<Availability> versions = std::nullopt)
      : wanted_(wanted), versions_(versions) {}

  /// Later values mean what they do on a board with these versions.
  void learn(const Availability& versions) { seen_ = versions; }

  /// `direction` is the direction of the frame; if it is missing, the frame size decides, unless
  /// the body can only be decoded in the other direction.
  DecodedFrame decode(const Frame& frame, std::optional<Direction> direction);

 private:
  DecodedFrame decode_from(const Frame& frame, Direction direction);
  Status decode_body(std::span<const std::uint8_t> body, const Contexts& contexts,
                     DecodedFrame& result);
  /// Puts a decoded message into the wanted forms.
  void take(const AnyMessage& message, DecodedFrame& result);
  /// Adds what else the body may be, if nobody has seen the request that decides it.
  void add_others(DecodedFrame& result);
  void add_other(const MessageType& type, DecodedFrame& result);
  /// Sets the explanation, and the rows of a body that is too short.
  void describe_error(DecodedFrame& result);
  /// Sets the rows of a body that is too short.
  void decode_arrived(DecodedFrame& result);
  /// Explains a size that no form has by what probably happened to the body.
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
