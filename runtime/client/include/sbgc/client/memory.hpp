/// The board's memory: EEPROM, files, data of the user.
///
/// Everything is checked before anything is sent, moved in whole pages that fit into a message,
/// and read back after writing. Errors of the board come as sentences.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/client/progress.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/messages/storage.hpp>

namespace sbgc {

/// How memory is moved. Progress counts bytes.
struct TransferOptions {
  /// For all of it.
  std::chrono::milliseconds timeout{120'000};
  /// Read back what has been written.
  bool verify = true;
  ProgressHandler progress{};
};

inline constexpr std::size_t user_data_size = decltype(msg::ReadExternalData::data){}.size();

namespace tasks {

using Bytes = std::vector<std::uint8_t>;

/// Reads `size` bytes of the EEPROM from `address` on; neither need be a multiple of the page size.
/// ErrorCode::invalid if they lie outside of the EEPROM.
Task<Result<Bytes>> download_eeprom(std::uint32_t address, std::size_t size,
                                    TransferOptions options = {});

/// Writes `data` to the EEPROM from `address` on. The board writes whole pages only: where the data
/// begin or end inside one, its other bytes are read first and written back as they are.
///
/// Board parameters live there, too: writing at a wrong place can make a board useless. After a
/// failure the error says up to which address the data were written.
Task<Result<void>> upload_eeprom(std::uint32_t address, Bytes data, TransferOptions options = {});

/// The size of a file in bytes; ErrorCode::not_found if there is no such file.
Task<Result<std::size_t>> file_size(std::uint16_t file);

/// Reads a whole file; ErrorCode::not_found if there is no such file.
Task<Result<Bytes>> download_file(std::uint16_t file, TransferOptions options = {});

/// Writes a whole file; one with the same id is replaced, and damaged if that fails half-way. It
/// cannot be empty: that is how the protocol deletes files.
Task<Result<void>> upload_file(std::uint16_t file, Bytes data, TransferOptions options = {});

/// Deletes a file; ErrorCode::not_found if there is no such file.
Task<Result<void>> delete_file(std::uint16_t file);

/// Deletes all files.
Task<Result<void>> delete_all_files();

/// Reads the whole area that the board keeps for data of the user.
Task<Result<Bytes>> download_user_data();

/// Writes `data` into this area at `offset`; its other bytes stay as they are. Read back.
Task<Result<void>> upload_user_data(std::size_t offset, Bytes data);

}  // namespace tasks
}  // namespace sbgc
