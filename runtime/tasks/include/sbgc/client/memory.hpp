/// The memory of the board: EEPROM, files and user data.
///
/// Arguments are checked before anything is sent. Transfers use whole pages that fit into a
/// message, and writes are verified by reading back. While the board answers in the first framing,
/// whose sums let some damage pass, what is read from the EEPROM or kept of the user data counts
/// only once two answers agree. Error codes of the board are translated to sentences.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/client/progress.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/messages/storage.hpp>

namespace sbgc {

/// Options of a memory transfer. Progress counts bytes.
struct TransferOptions {
  /// For the whole transfer.
  std::chrono::milliseconds timeout{120'000};
  /// Read back the written data.
  bool verify = true;
  ProgressHandler progress{};
};

/// The size of the memory that a board has for programs of users, in bytes.
inline constexpr std::size_t user_data_size = decltype(msg::ReadExternalData::data){}.size();

namespace tasks {

/// Contents of the EEPROM or of a file.
using Bytes = std::vector<std::uint8_t>;

/// Reads `size` bytes of the EEPROM from `address`; neither needs to be a multiple of the page
/// size. Fails with ErrorCode::invalid if the range exceeds the EEPROM.
Task<Result<Bytes>> download_eeprom(std::uint32_t address, std::size_t size,
                                    TransferOptions options = {});

/// Writes `data` to the EEPROM at `address`. The board writes whole pages only: if the data start
/// or end inside a page, its other bytes are read first and written back unchanged.
///
/// The EEPROM also holds the board's parameters: writing to a wrong address can make a board
/// unusable. If the transfer fails, the error reports the address up to which the data were
/// written.
Task<Result<void>> upload_eeprom(std::uint32_t address, Bytes data, TransferOptions options = {});

/// Returns the size of a file in bytes. Fails with ErrorCode::not_found if there is no such file.
Task<Result<std::size_t>> file_size(std::uint16_t file);

/// Reads a whole file. Fails with ErrorCode::not_found if there is no such file.
Task<Result<Bytes>> download_file(std::uint16_t file, TransferOptions options = {});

/// Writes a whole file and replaces a file with the same id. If the transfer fails, that file may
/// be damaged. `data` must not be empty: the protocol deletes a file by writing an empty one.
Task<Result<void>> upload_file(std::uint16_t file, Bytes data, TransferOptions options = {});

/// Deletes a file. Fails with ErrorCode::not_found if there is no such file.
Task<Result<void>> delete_file(std::uint16_t file);

/// Deletes all files.
Task<Result<void>> delete_all_files();

/// Reads the whole area that the board reserves for user data.
Task<Result<Bytes>> download_user_data();

/// Writes `data` to this area at `offset` and verifies it; other bytes stay unchanged.
Task<Result<void>> upload_user_data(std::size_t offset, Bytes data);

}  // namespace tasks
}  // namespace sbgc
