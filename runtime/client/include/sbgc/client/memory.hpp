/// The board's memory: EEPROM, files, data of the user.
///
/// Everything is checked before anything is sent, moved in whole pages that fit into a message,
/// and read back after writing. Errors of the board come as sentences.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <sbgc/client/clock.hpp>
#include <sbgc/client/progress.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/messages/storage.hpp>

namespace sbgc {

class Client;

/// How memory is moved. Progress counts bytes.
struct TransferOptions {
  /// For all of it.
  std::chrono::milliseconds timeout{120'000};
  /// Read back what has been written.
  bool verify = true;
  ProgressHandler progress{};
  Clock& clock = Clock::system();
};

/// Reads `size` bytes of the EEPROM from `address` on; neither need be a multiple of the page size.
/// ErrorCode::invalid if they lie outside of the EEPROM.
Result<std::vector<std::uint8_t>> read_eeprom(Client& client, std::uint32_t address,
                                              std::size_t size,
                                              const TransferOptions& options = {});

/// Writes `data` to the EEPROM from `address` on. The board writes whole pages only: where the data
/// begin or end inside one, its other bytes are read first and written back as they are.
///
/// Board settings live there, too: writing at a wrong place can make a board useless. After a
/// failure the error says up to which address the data stand there.
Result<void> write_eeprom(Client& client, std::uint32_t address, std::span<const std::uint8_t> data,
                          const TransferOptions& options = {});

/// The size of a file in bytes; ErrorCode::not_found if there is no such file.
Result<std::size_t> file_size(Client& client, std::uint16_t file);

/// Reads a whole file; ErrorCode::not_found if there is no such file.
Result<std::vector<std::uint8_t>> read_file(Client& client, std::uint16_t file,
                                            const TransferOptions& options = {});

/// Writes a whole file; one with the same id is replaced, and damaged if that fails half-way. It
/// can not be empty: that is how the protocol deletes files.
Result<void> write_file(Client& client, std::uint16_t file, std::span<const std::uint8_t> data,
                        const TransferOptions& options = {});

/// Deletes a file; ErrorCode::not_found if there is no such file.
Result<void> delete_file(Client& client, std::uint16_t file);

/// Deletes all files.
Result<void> delete_all_files(Client& client);

inline constexpr std::size_t external_data_size = decltype(msg::ReadExternalData::data){}.size();

/// Reads the whole area that the board keeps for data of the user.
Result<std::vector<std::uint8_t>> read_external_data(Client& client);

/// Writes `data` into this area at `offset`; its other bytes stay as they are. Read back.
Result<void> write_external_data(Client& client, std::size_t offset,
                                 std::span<const std::uint8_t> data);

}  // namespace sbgc
