// Reading one byte past an input, or writing one past an output, ends the program here: after each
// of them is a page without access. A sanitizer does not see such an access if it is inside a
// larger object, such as a buffer of the caller.

#if __has_include(<sys/mman.h>)

#include <stdexcept>

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <sbgc/dispatch.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/small_parser.hpp>

#include "streams.hpp"

namespace sbgc::test {
namespace {

/// Memory between two pages without access.
class GuardedMemory {
 public:
  explicit GuardedMemory(std::size_t size) {
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    inside_ = (size + page - 1) / page * page;
    mapped_ = inside_ + 2 * page;
    void* const all = ::mmap(nullptr, mapped_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) throw std::runtime_error("mmap failed");
    begin_ = static_cast<std::uint8_t*>(all) + page;
    if (::mprotect(begin_, inside_, PROT_READ | PROT_WRITE) != 0) {
      throw std::runtime_error("mprotect failed");
    }
  }
  GuardedMemory(const GuardedMemory&) = delete;
  GuardedMemory& operator=(const GuardedMemory&) = delete;
  ~GuardedMemory() { ::munmap(begin_ - (mapped_ - inside_) / 2, mapped_); }

  /// Returns the last bytes before the page without access.
  std::span<std::uint8_t> at_end(std::size_t size) { return std::span(begin_, inside_).last(size); }
  std::span<const std::uint8_t> at_end(std::span<const std::uint8_t> content) {
    const std::span<std::uint8_t> place = at_end(content.size());
    std::ranges::copy(content, place.begin());
    return place;
  }
  /// Returns a copy directly after the other page without access.
  std::span<const std::uint8_t> at_begin(std::span<const std::uint8_t> content) {
    const std::span<std::uint8_t> place = std::span(begin_, inside_).first(content.size());
    std::ranges::copy(content, place.begin());
    return place;
  }

 private:
  std::size_t inside_{};
  std::size_t mapped_{};
  std::uint8_t* begin_{};
};

template <class P>
ParserCounters counted(std::span<const std::uint8_t> stream) {
  P parser;
  parser.feed(stream, [](const Frame&) {});
  parser.flush([](const Frame&) {});
  return parser.counters();
}

template <class P>
void check_parser(Accepts accepts) {
  GuardedMemory memory(4096);
  Random random(1, accepts);
  for (int repetition = 0; repetition < 200; ++repetition) {
    const Bytes stream = random.stream(3);
    // Every position in blocks of 16 bytes is the last one once.
    for (std::size_t size = stream.size() - std::min<std::size_t>(stream.size(), 40);
         size <= stream.size(); ++size) {
      const auto some = std::span(stream).first(size);
      const ParserCounters expected = counted<P>(some);
      ASSERT_EQ(counted<P>(memory.at_end(some)), expected);
      ASSERT_EQ(counted<P>(memory.at_begin(some)), expected);
    }
  }
}

using ParserOfBoth = BasicParser<AnyFrameFormats>;

TEST(PageEnd, ParsersReadOnlyTheirChunk) {
  check_parser<Parser>(Accepts::v1);
  check_parser<SmallParser>(Accepts::v1);
  check_parser<ParserOfAll>(Accepts::both);
  check_parser<ParserOfBoth>(Accepts::both);
}

/// Quiet bytes have no candidate that would end the search early.
TEST(PageEnd, ParsersReadOnlyTheirChunkWithoutAnyStart) {
  GuardedMemory memory(8192);
  for (std::size_t size = 0; size < 8192; size += size < 600 ? 1 : 41) {
    const Bytes quiet(size, 0x11);
    EXPECT_EQ(counted<Parser>(memory.at_end(quiet)).skipped_bytes, size);
    EXPECT_EQ(counted<ParserOfAll>(memory.at_end(quiet)).skipped_bytes, size);
  }
}

template <class M>
void check_message(GuardedMemory& memory) {
  SCOPED_TRACE(Meta<M>::info.name);
  Random random(2);
  for (std::size_t size = 0; size <= max_body_size; ++size) {
    Bytes body = random.noise(size);
    if (size != 0 && size % 3 == 0) body[0] = static_cast<std::uint8_t>(size % 5);
    M message{};
    if (!decode(memory.at_end(body), message)) continue;
    M again{};
    ASSERT_TRUE(decode(memory.at_begin(body), again));
    std::vector<std::uint8_t> written(max_body_size);
    const auto result = encode(message, written);
    if (!result) continue;
    written.resize(result.size);
    const std::span<std::uint8_t> exact = memory.at_end(result.size);
    ASSERT_EQ(encode(message, exact).size, result.size);
    ASSERT_TRUE(std::ranges::equal(exact, written));
    if (result.size != 0) {
      ASSERT_FALSE(encode(message, memory.at_end(result.size - 1)));
    }
  }
}

TEST(PageEnd, MessagesReadAndWriteOnlyTheirBody) {
  GuardedMemory memory(max_body_size);
  AllMessages::for_each([&]<class M>(Type<M>) { check_message<M>(memory); });
}

}  // namespace
}  // namespace sbgc::test

#endif
