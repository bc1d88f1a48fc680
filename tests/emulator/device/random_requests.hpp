/// Frames to a board: requests with random values, and invalid bytes.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <sbgc/dispatch.hpp>
#include <sbgc/frame.hpp>

namespace sbgc::test {

using Bytes = std::vector<std::uint8_t>;

inline Bytes frame_of(std::uint8_t id, std::span<const std::uint8_t> body) {
  std::array<std::uint8_t, max_frame_size> frame{};
  const WriteResult written = write_frame(id, body, frame);
  return {frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(written.size)};
}

/// Each request has a form of the model; one in eight has a wrong size, one in eight is not a
/// frame.
class RandomRequests {
 public:
  explicit RandomRequests(std::uint32_t seed) : random_(seed) {
    AllMessages::for_each([this]<class M>(Type<M>) {
      if constexpr (M::direction != Direction::from_board) {
        forms_.push_back({static_cast<std::uint8_t>(M::command), M::min_size, M::max_size});
      }
    });
  }

  std::uint32_t up_to(std::uint32_t most) {
    return std::uniform_int_distribution<std::uint32_t>(0, most)(random_);
  }

  Bytes next() {
    const Form& form = forms_[up_to(static_cast<std::uint32_t>(forms_.size()) - 1)];
    const std::uint32_t kind = up_to(7);
    auto size = static_cast<std::uint32_t>(form.min_size);
    if (form.max_size > form.min_size && up_to(1) == 0) {
      size += up_to(static_cast<std::uint32_t>(form.max_size - form.min_size));
    }
    if (kind == 0) size = up_to(max_body_size);
    Bytes body(size);
    // Small numbers are meaningful more often.
    const std::uint32_t most = up_to(2) == 0 ? 255 : 4;
    for (auto& byte : body) byte = static_cast<std::uint8_t>(up_to(most));
    if (kind == 1) return body;
    return frame_of(form.id, body);
  }

 private:
  struct Form {
    std::uint8_t id{};
    std::size_t min_size{}, max_size{};
  };

  std::mt19937 random_;
  std::vector<Form> forms_{};
};

}  // namespace sbgc::test
