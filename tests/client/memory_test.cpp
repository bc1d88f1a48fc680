#include <numeric>

#include <sbgc/client/memory.hpp>

#include "task_test.hpp"
#include "tasks/pages.hpp"

namespace sbgc::test {
namespace {

using detail::page_runs;
using detail::PageRun;

std::vector<std::uint8_t> bytes(std::size_t size, unsigned seed = 1) {
  std::vector<std::uint8_t> result(size);
  for (std::size_t i = 0; i < size; ++i) result[i] = static_cast<std::uint8_t>(seed + i * 13 / 7);
  return result;
}

TEST(PageRuns, AreWholePagesThatCoverTheBytes) {
  EXPECT_THAT(page_runs(0, 0, 64, 192), IsEmpty());
  EXPECT_THAT(page_runs(0, 1, 64, 192), ElementsAre(PageRun{0, 64}));
  EXPECT_THAT(page_runs(63, 2, 64, 192), ElementsAre(PageRun{0, 128}));
  EXPECT_THAT(page_runs(128, 400, 64, 200),
              ElementsAre(PageRun{128, 192}, PageRun{320, 192}, PageRun{512, 64}));
}

TEST(PageRuns, CoverEveryByteOnceAndNoPageTooMany) {
  for (std::uint64_t address = 0; address < 200; ++address) {
    for (std::size_t size = 1; size < 600; size += 7) {
      std::uint64_t at = address / 64 * 64;
      for (const PageRun& run : page_runs(address, size, 64, 192)) {
        ASSERT_EQ(run.address, at);
        ASSERT_EQ(run.size % 64, 0U);
        ASSERT_LE(run.size, 192U);
        at += run.size;
      }
      ASSERT_GE(at, address + size);
      ASSERT_LT(at - (address + size), 64U);
    }
  }
}

TEST(PageRuns, ReachTheEndOfTheAddressSpace) {
  EXPECT_THAT(page_runs(0xFFFFFFC0, 64, 64, 192), ElementsAre(PageRun{0xFFFFFFC0, 64}));
}

class MemoryTest : public TaskTest {
 protected:
  /// Fills the EEPROM with bytes that are neither settings nor files.
  void fill_eeprom() {
    emulator::Memory memory;
    for (std::size_t i = 0; i < memory.eeprom.size(); ++i) {
      memory.eeprom[i] = static_cast<std::uint8_t>(i * 7 / 3);
    }
    board.become(board.options(), memory);
  }
  std::vector<std::uint8_t> file(std::uint16_t id) {
    std::vector<std::uint8_t> result;
    msg::ReadFileRequest request{.file_id = id};
    request.max_data_size = msg::ByteCount(64);
    while (true) {
      const Packets answer = board.ask(packet(request));
      if (answer.empty() || !is<msg::ReadFile>(answer[0])) break;
      const auto part = message<msg::ReadFile>(answer[0]);
      if (part.data.empty()) break;
      result.insert(result.end(), part.data.begin(), part.data.end());
      request.page_offset =
          decltype(request.page_offset)(static_cast<std::uint16_t>(request.page_offset.raw() + 1));
    }
    return result;
  }
  void put_file(std::uint16_t id, const std::vector<std::uint8_t>& content) {
    msg::WriteFile request{.file_id = id};
    request.file_size = msg::ByteCount(static_cast<std::uint16_t>(content.size()));
    for (const std::uint8_t byte : content) request.data.push_back(byte);
    board.write(request);
  }
};

TEST_F(MemoryTest, EepromIsReadFromAnywhere) {
  fill_eeprom();
  const auto eeprom = board.memory().eeprom;
  for (const auto& [address, size] : std::vector<std::pair<std::uint32_t, std::size_t>>{
           {0, 64}, {64, 192}, {100, 1}, {127, 2}, {1000, 777}, {32767, 1}, {0, 32768}, {5, 0}}) {
    const auto read = checked(client().download_eeprom(address, size));
    const auto first = eeprom.begin() + address;
    EXPECT_EQ(*read, std::vector<std::uint8_t>(first, first + static_cast<std::ptrdiff_t>(size)))
        << address << ' ' << size;
  }
}

TEST_F(MemoryTest, EepromOutsideOfTheChipIsRefusedBeforeAnythingIsSent) {
  EXPECT_EQ(client().download_eeprom(32768, 1).error().code, ErrorCode::invalid);
  EXPECT_THAT(client().download_eeprom(32700, 100).error().message, HasSubstr("32768"));
  EXPECT_FALSE(client().upload_eeprom(0xFFFFFFFF, bytes(2)));
  EXPECT_THAT(board.log(), IsEmpty());
}

TEST_F(MemoryTest, EepromIsWrittenWithoutTouchingWhatIsAround) {
  fill_eeprom();
  for (const auto& [address, size] : std::vector<std::pair<std::uint32_t, std::size_t>>{
           {0, 64}, {64, 500}, {100, 1}, {127, 2}, {1001, 776}, {32767, 1}, {5, 0}}) {
    auto expected = board.memory().eeprom;
    const auto data = bytes(size, address);
    std::copy(data.begin(), data.end(), expected.begin() + address);
    require(client().upload_eeprom(address, data));
    EXPECT_EQ(board.memory().eeprom, expected) << address << ' ' << size;
  }
}

TEST_F(MemoryTest, EepromThatDoesNotKeepWhatIsWrittenIsNoticed) {
  board.after([&](const Packet& request) {
    if (!is<msg::EepromWrite>(request)) return;
    msg::EepromWrite other{.addr = 0x200};
    for (const std::uint8_t byte : message<msg::EepromWrite>(request).data)
      other.data.push_back(byte);
    other.data.resize(64);
    other.data[0x10] = 0xEE;
    board.write(other);
  });
  auto data = bytes(1000);
  data[0x10] = 0x11;
  EXPECT_THAT(client().upload_eeprom(0x200, data), fails(ErrorCode::mismatch,
                                                         "wrote 0x11, but read back 0xee at "
                                                         "0x210; nothing was verifiably written"));
}

TEST_F(MemoryTest, AFailureTellsUpToWhereTheDataStand) {
  connect(few_retries);
  board.on_lost([](const Packet& request) {
    return is<msg::EepromWrite>(request) && message<msg::EepromWrite>(request).addr >= 384;
  });
  EXPECT_THAT(client().upload_eeprom(0, bytes(1000)),
              fails(ErrorCode::timeout, "the data are written up to 0x180"));
}

TEST_F(MemoryTest, TransfersTellTheirProgressAndCanBeCancelled) {
  std::vector<std::size_t> done;
  TransferOptions options;
  options.progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.total, 500U);
    done.push_back(progress.done);
    return true;
  };
  EXPECT_TRUE(client().upload_eeprom(100, bytes(500), options));
  EXPECT_THAT(done, ElementsAre(0, 156, 348, 500));
  done.clear();
  EXPECT_TRUE(client().download_eeprom(100, 500, options));
  EXPECT_THAT(done, ElementsAre(0, 156, 348, 500));
  options.progress = [](const Progress& progress) { return progress.done == 0; };
  EXPECT_EQ(client().download_eeprom(0, 500, options).error().code, ErrorCode::cancelled);
}

TEST_F(MemoryTest, FilesComeBackAsTheyWereWritten) {
  for (const std::size_t size : std::vector<std::size_t>{1, 63, 64, 192, 193, 1000, 16000}) {
    const auto data = bytes(size);
    require(client().upload_file(7, data));
    EXPECT_EQ(file(7), data) << size;
    EXPECT_EQ(*client().download_file(7), data) << size;
    EXPECT_EQ(*client().file_size(7), size);
  }
}

TEST_F(MemoryTest, AnEmptyFileCanBeRead) {
  // An emulated board has no empty file.
  put_file(3, bytes(10));
  board.tamper([](Packets& answers) {
    for (Packet& one : answers) {
      if (!is<msg::ReadFile>(one)) continue;
      auto empty = message<msg::ReadFile>(one);
      empty.file_size = {};
      empty.data.clear();
      one = packet(empty);
    }
  });
  const auto read = checked(client().download_file(3));
  EXPECT_THAT(*read, IsEmpty());
}

TEST_F(MemoryTest, FilesThatCannotBeAreRefusedBeforeAnythingIsSent) {
  EXPECT_EQ(client().upload_file(7, {}).error().code, ErrorCode::invalid);
  EXPECT_EQ(client().upload_file(7, bytes(65536)).error().code, ErrorCode::invalid);
  EXPECT_THAT(board.log(), IsEmpty());
}

TEST_F(MemoryTest, AMissingFileIsNotFound) {
  EXPECT_EQ(client().download_file(9).error().code, ErrorCode::not_found);
  EXPECT_EQ(client().file_size(9).error().code, ErrorCode::not_found);
  EXPECT_EQ(client().delete_file(9).error().code, ErrorCode::not_found);
  EXPECT_THAT(client().download_file(9).error().message,
              HasSubstr("file 9: No file has this id. (ERR_FILE_NOT_FOUND)"));
}

TEST_F(MemoryTest, ErrorsOfTheFileSystemAreSentences) {
  const auto error = client().upload_file(9, bytes(20000)).error();
  EXPECT_EQ(error.code, ErrorCode::board_error);
  EXPECT_THAT(error.message, HasSubstr("The memory is full. (ERR_NO_FREE_SPACE)"));
}

TEST_F(MemoryTest, FilesAreDeleted) {
  for (std::uint16_t id = 1; id <= 3; ++id) put_file(id, bytes(5, id));
  EXPECT_TRUE(client().delete_file(2));
  EXPECT_EQ(file(1), bytes(5, 1));
  EXPECT_THAT(file(2), IsEmpty());
  EXPECT_EQ(file(3), bytes(5, 3));
  EXPECT_TRUE(client().delete_all_files());
  for (std::uint16_t id = 1; id <= 3; ++id) EXPECT_THAT(file(id), IsEmpty());
}

TEST_F(MemoryTest, AFileThatIsReadBackDifferentlyIsNoticed) {
  board.after([&](const Packet& request) {
    if (!is<msg::WriteFile>(request)) return;
    auto content = bytes(10);
    content[2] = 0xEE;
    put_file(5, content);
  });
  EXPECT_THAT(client().upload_file(5, bytes(10)), fails(ErrorCode::mismatch, "from byte 2"));
}

TEST_F(MemoryTest, DataOfTheUserAreChangedInPart) {
  auto expected = board.settings<msg::ReadExternalData>().data;
  expected[100] = 1;
  expected[101] = 2;
  const std::vector<std::uint8_t> data{1, 2};
  EXPECT_TRUE(client().upload_user_data(100, data));
  EXPECT_EQ(board.settings<msg::ReadExternalData>().data, expected);
  const auto read = checked(client().download_user_data());
  EXPECT_TRUE(std::equal(read->begin(), read->end(), expected.begin(), expected.end()));
  EXPECT_FALSE(client().upload_user_data(127, data));
  EXPECT_FALSE(client().upload_user_data(0, bytes(129)));
}

}  // namespace
}  // namespace sbgc::test
