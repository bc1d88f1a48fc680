/// All parameters of a board: reading, comparing and writing them.
///
/// The specification defines which messages hold parameters, how many copies the board has of each
/// (one per profile), and which fields hold state of the board instead of parameters; see
/// <sbgc/parameters.hpp>.
///
/// Volatile and stored parameters: a board works with the parameters of its active profile in
/// volatile memory. The write messages change them there and also save them to the EEPROM.
/// Adjustable variables change only the volatile ones, until CMD_SAVE_PARAMS_3 saves them to the
/// active profile (see <sbgc/client/variables.hpp>). Until then, the parameters read for the active
/// profile may hold values that the next restart discards.
///
/// General parameters (FieldRole::general) apply to the whole board, but are part of the copy of
/// each profile. Writing one profile changes the values that are read for the others: to change a
/// general parameter, change it in all profiles. The protocol documents few of them, so a board may
/// have more, or keep some per profile. That is why write_parameters() reads all parameters again
/// at the end.
///
/// Damaged answers: the checksums of the first framing miss some damage (docs/3-connecting.md).
/// While a board answers in it, a block counts as read only once two answers agree, so that no
/// wrong value gets into a backup, or from there or from a read-modify-write back to the board; a
/// reading that six answers cannot settle fails with ErrorCode::mismatch. A block that reads back
/// differently from what was written is read again, and then written once more.
///
/// Parameters take effect at once; wrong ones make a gimbal shake or spin. See docs/2-safety.md.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/progress.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/result.hpp>

namespace sbgc {

/// A message that holds parameters.
template <class M>
concept ParameterMessage = requires {
  ParametersOf<M>::copies;
};

/// Identifies parameters: the name of the message that holds them, and the copy, counted from 0.
struct ParametersId {
  std::string message{};  ///< for example "ReadParams3"
  std::uint8_t copy{};    ///< the profile, for most messages

  bool operator==(const ParametersId&) const = default;
};

/// For example "ReadParams3 of profile 2" or "ReadProfileNames".
std::string to_text(const ParametersId& id);
/// The same for several, separated by commas.
std::string to_text(const std::vector<ParametersId>& ids);

/// The parameters of one message, as its body.
struct Parameters {
  ParametersId id{};
  std::vector<std::uint8_t> body{};  ///< as the board sends it

  bool operator==(const Parameters&) const = default;
};

/// All or some parameters of a board. Every block can be decoded.
class ParameterSet {
 public:
  /// Returns all blocks, in the order in which they were added.
  const std::vector<Parameters>& all() const noexcept { return blocks_; }
  /// Returns the block with this id; null if the set has none.
  const Parameters* find(const ParametersId& id) const noexcept;

  /// Adds a block, or replaces the one with the same id. Errors: `invalid` if no message holds such
  /// parameters, if the message cannot have this body, or if the body is of another copy.
  Result<void> put(Parameters block);

  /// Returns the parameters of copy `copy`. Errors: `not_found` if the set has none.
  template <ParameterMessage M>
  Result<M> get(std::uint8_t copy = 0) const {
    const Parameters* const block = find({ParametersOf<M>::name, copy});
    if (block == nullptr) return missing({ParametersOf<M>::name, copy});
    M message{};
    static_cast<void>(decode(std::span(block->body), message));  // put() has checked this
    return message;
  }

  /// Adds parameters; the message determines the copy. Errors: those of put().
  template <ParameterMessage M>
  Result<void> set(const M& message) {
    std::uint8_t copy = 0;
    if constexpr (ParametersOf<M>::copies > 1) copy = ParametersOf<M>::copy(message);
    std::vector<std::uint8_t> body(max_body_size);
    body.resize(encode(message, body).size);
    return put({{ParametersOf<M>::name, copy}, std::move(body)});
  }

  bool operator==(const ParameterSet&) const = default;

 private:
  static ClientError missing(const ParametersId& id);

  std::vector<Parameters> blocks_{};
};

/// A field whose value differs. The text of a field that a shorter body lacks is empty.
struct FieldChange {
  std::string path{};            ///< for example "axes.roll.p"
  std::string before{};          ///< as on the wire
  std::string after{};           ///< as on the wire
  std::string before_meaning{};  ///< for example "-30 deg" or "FOLLOW_MODE_FC"; may be ""
  std::string after_meaning{};   ///< the same for `after`

  bool operator==(const FieldChange&) const = default;
};

/// The changes within one block, or the fact that only one set has it.
struct ParametersChange {
  /// Whether both sets have the block, or one of them.
  enum class Kind : std::uint8_t { changed, only_before, only_after };

  ParametersId id{};
  Kind kind{};
  std::vector<FieldChange> fields{};  ///< of `changed`

  bool operator==(const ParametersChange&) const = default;
};

/// Returns the differences of two sets, field by field, in the order of `before`. Ignores fields
/// that hold state of the board, such as the active profile. Values are interpreted as on boards
/// with the versions of each set, or in the usual way without versions.
std::vector<ParametersChange> diff(const ParameterSet& before, const ParameterSet& after,
                                   const Availability& versions_before = {},
                                   const Availability& versions_after = {});

/// For people: a heading per block, a line per field; "" if there are no changes.
std::string to_text(const std::vector<ParametersChange>& changes);

/// Options of read_parameters().
struct ReadOptions {
  /// The timeout of the whole operation.
  std::chrono::milliseconds timeout{60'000};
  ProgressHandler progress{};  ///< returning false ends it with ErrorCode::cancelled
  /// Returns true for the parameters to read; if empty, all are read.
  std::function<bool(const ParametersId&)> wanted{};
};

/// Options of write_parameters().
struct WriteOptions {
  /// The timeout of the whole operation. No block is sent in the last 250 ms, because its
  /// confirmation might not arrive in time.
  std::chrono::milliseconds timeout{120'000};
  /// Only report what would be written.
  bool dry_run = false;
  /// Reject values that the protocol does not allow on this board in the fields that change, and
  /// general parameters that differ between the wanted profiles but not on the board.
  bool validate = true;
  ProgressHandler progress{};  ///< returning false ends it with ErrorCode::cancelled
};

/// The known state of one block on the board.
enum class ParametersState : std::uint8_t {
  equal,      ///< the board already held the wanted values
  written,    ///< the block was written and verified
  unwritten,  ///< the board still holds the previous values
  different,  ///< read back, but neither the wanted nor the previous values
  unknown,    ///< sent, but could not be read back
};

/// The name of a state, such as "written".
const char* name(ParametersState state) noexcept;

/// The report on one block.
struct ParametersReport {
  ParametersId id{};
  ParametersState state = ParametersState::unwritten;  ///< what is known of the board
  /// The wanted changes, relative to the previous parameters of the board.
  std::vector<FieldChange> wanted{};
  /// The differences between the board and the wanted values, if the state is `different`.
  std::vector<FieldChange> deviation{};
};

/// The report of write_parameters(), also after a failure.
struct WriteReport {
  WriteReport() = default;
  /// Converts an error that occurred before anything was done.
  // NOLINTNEXTLINE(google-explicit-constructor): `return error;`
  WriteReport(ClientError error) : outcome(std::move(error)) {}

  /// Success if the board holds all wanted parameters, or would hold them after a dry run.
  Result<void> outcome{};
  std::vector<ParametersReport> parameters{};  ///< one for each wanted block

  /// True if `outcome` is a success.
  explicit operator bool() const noexcept { return static_cast<bool>(outcome); }
};

/// For people: the outcome, and the state of each block.
std::string to_text(const WriteReport& report);

namespace tasks {

/// Reads the parameters that this board and firmware have: all, or those that are wanted. In the
/// first framing, reads each block at least twice. Errors: those of Client::call(); `mismatch` if
/// the answers do not agree; `cancelled` by ReadOptions::progress.
Task<Result<ParameterSet>> read_parameters(ReadOptions options = {});

/// Sets the parameters of the board to those in `wanted`; others keep their values.
///
/// Reads all parameters first and detects errors before writing anything, as far as possible.
/// Writes only the blocks that differ, confirms each one and reads it back. Reads all parameters
/// again at the end. Fields that hold state of the board, and bytes of the board past the end of a
/// wanted body, are written back unchanged. A failure does not undo earlier writes: the report says
/// what the board holds.
///
/// Errors, in WriteReport::outcome: those of read_parameters(); before anything is written,
/// `unsupported` or `incompatible` for what this board lacks, and `invalid` for values; `mismatch`
/// if the board holds other values afterwards.
Task<WriteReport> write_parameters(ParameterSet wanted, WriteOptions options = {});

}  // namespace tasks
}  // namespace sbgc
