/// A decoded frame and its description.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sbgc/frame.hpp>
#include <sbgc/to_json.hpp>
#include <sbgc/visit.hpp>

namespace sbgc::tools {

/// One value of a message in readable form.
struct Row {
  std::string path;
  std::string raw;
  std::string meaning;    ///< the value in its unit, or its name
  std::string objection;  ///< violation of the specification, such as "is below 1 Hz", or with its
                          ///< own subject, "MODE_RC needs firmware 2.66"
  std::size_t offset{};   ///< offset of the value in the body
  std::size_t size{};     ///< size of the value in bytes
};

/// The result of decoding one frame.
struct DecodedFrame {
  Frame frame{};
  Direction direction{};
  std::string command{};                 ///< "" if the id is unknown
  const MessageInfo* message = nullptr;  ///< null if no message fits
  Status status{};
  std::string error_field{};  ///< the field of the error, if known
  Json fields{};
  std::vector<Row> rows{};
  bool is_for_firmware{};   ///< checked against the versions of a certain board
  std::string objection{};  ///< why a board with these versions does not know the message, or ""

  /// Returns the object that `sbgc decode --format jsonl` prints.
  Json to_json() const;
};

/// Decodes frames in sequence and stores the context for later ones.
class FrameDecoder {
 public:
  FrameDecoder() = default;
  /// Objects to what a board with these versions does not know.
  explicit FrameDecoder(const Availability& versions) : versions_(versions) {}

  /// `direction` is the direction of the frame; if it is missing, the frame size decides, unless
  /// the body can only be decoded in the other direction.
  DecodedFrame decode(const Frame& frame, std::optional<Direction> direction);

 private:
  DecodedFrame decode_from(const Frame& frame, Direction direction);

  std::optional<Availability> versions_;
  Contexts contexts_;
};

}  // namespace sbgc::tools
