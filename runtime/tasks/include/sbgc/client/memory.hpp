/// The memory of the board: EEPROM, files and user data.
///
/// Arguments are checked before anything is sent. Transfers use whole pages that fit into a
/// message, and writes are verified by reading back. While the board answers in the first framing,
/// whose checksums miss some damage, data that are read from the EEPROM or kept of the user data
/// count only once two answers agree. Error codes of the board are translated to sentences.
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
  /// The timeout of the whole transfer.
  std::chrono::milliseconds timeout{120'000};
  /// Read back the written data.
  bool verify = true;
  ProgressHandler progress{};  ///< returning false ends it with ErrorCode::cancelled
};

/// The size of the memory area that a board reserves for user data, in bytes.
inline constexpr std::size_t user_data_size = decltype(msg::ReadExternalData::data){}.size();

namespace tasks {

/// Contents of the EEPROM or of a file.
using Bytes = std::vector<std::uint8_t>;

/// Reads `size` bytes of the EEPROM from `address`; neither needs to be a multiple of the page
/// size. Errors: those of Client::call(), `invalid` if the range exceeds the EEPROM, `mismatch` if
/// the answers do not agree, `cancelled` by TransferOptions::progress.
Task<Result<Bytes>> download_eeprom(std::uint32_t address, std::size_t size,
                                    TransferOptions options = {});

/// Writes `data` to the EEPROM at `address`. The board writes whole pages only: if the data start
/// or end inside a page, its other bytes are read first and written back unchanged.
///
/// The EEPROM also holds the board's parameters: writing to a wrong address can make a board
/// unusable. If the transfer fails, the error reports the address up to which the data were
/// written. Errors: those of download_eeprom(); `mismatch` also if the data read back differ.
Task<Result<void>> upload_eeprom(std::uint32_t address, Bytes data, TransferOptions options = {});

/// Returns the size of a file in bytes. Errors: those of Client::call(); `not_found` if there is no
/// such file.
Task<Result<std::size_t>> file_size(std::uint16_t file);

/// Reads a whole file. Errors: those of file_size(); `mismatch` if its size changes meanwhile,
/// `cancelled` by TransferOptions::progress.
Task<Result<Bytes>> download_file(std::uint16_t file, TransferOptions options = {});

/// Writes a whole file and replaces a file with the same id. If the transfer fails, that file may
/// be damaged. `data` must not be empty: the protocol deletes a file by writing an empty one.
/// Errors: those of Client::call(); `invalid` for the size; `mismatch` if it reads back
/// differently; `cancelled` by TransferOptions::progress.
Task<Result<void>> upload_file(std::uint16_t file, Bytes data, TransferOptions options = {});

/// Deletes a file. Errors: those of file_size().
Task<Result<void>> delete_file(std::uint16_t file);

/// Deletes all files. Errors: those of Client::call().
Task<Result<void>> delete_all_files();

/// Reads the whole area that the board reserves for user data. Errors: those of Client::call();
/// `mismatch` if the answers do not agree.
Task<Result<Bytes>> download_user_data();

/// Writes `data` to this area at `offset` and verifies it; other bytes stay unchanged.
/// Errors: `invalid` if the data do not fit, and those of write_parameters().
Task<Result<void>> upload_user_data(std::size_t offset, Bytes data);

}  // namespace tasks
}  // namespace sbgc
