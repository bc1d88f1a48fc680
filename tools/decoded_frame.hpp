/// A frame and everything that can be said about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sbgc/frame.hpp>
#include <sbgc/to_json.hpp>
#include <sbgc/visit.hpp>

namespace sbgc::tools {

/// One value of a message, as people read it.
struct Row {
  std::string path;
  std::string raw;
  std::string meaning;    ///< the value in its unit, or its name
  std::string objection;  ///< why the specification does not allow it, such as "is below 1 Hz"
  std::size_t offset{};   ///< of its bytes in the body
  std::size_t size{};     ///< how many bytes it takes
};

/// What became of one frame.
struct DecodedFrame {
  Frame frame{};
  Direction direction{};
  std::string command{};                 ///< "" if the id is unknown
  const MessageInfo* message = nullptr;  ///< null if no message fits
  Status status{};
  std::string error_field{};  ///< the field that `status` is about, as far as it is known
  Json fields{};
  std::vector<Row> rows{};

  /// The object that `sbgc decode --format jsonl` prints.
  Json to_json() const;
};

/// Decodes frame after frame and remembers what later ones need.
class FrameDecoder {
 public:
  /// `direction` says who sent the frame; without it, it is taken for what its size fits.
  DecodedFrame decode(const Frame& frame, std::optional<Direction> direction);

 private:
  Contexts contexts_;
};

}  // namespace sbgc::tools
