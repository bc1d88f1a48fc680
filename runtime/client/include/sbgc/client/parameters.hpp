/// All parameters of a board: reading them, comparing them, writing them back.
///
/// Which messages hold parameters, how many copies the board has of each (one for each profile),
/// and which fields are no parameters but state of the board, is what the specification says; see
/// <sbgc/settings.hpp>.
///
/// Volatile and stored parameters: a board works with the parameters of its active profile in
/// volatile memory. The write messages change them there and save them to the EEPROM as well.
/// Adjustable variables change the volatile ones only, until CMD_SAVE_PARAMS_3 saves them to the
/// active profile (see <sbgc/client/variables.hpp>); until then the parameters read for the active
/// profile may hold values that the next start forgets.
///
/// General parameters, of the board as a whole, stand in the copy of each profile, among those of
/// the profile (FieldRole::general). Writing one profile changes what is read of them for the
/// others: to change one, change it in all profiles. The protocol hardly says which they are, so a
/// board may know others, or keep some of them in each profile, which is why write_parameters()
/// looks at all of them again in the end.
///
/// Parameters act at once; wrong ones make a gimbal shake or spin. See docs/2-safety.md.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/client/progress.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/settings.hpp>

namespace sbgc {

/// A message that holds parameters.
template <class M>
concept ParameterMessage = requires {
  SettingsOf<M>::copies;
};

/// Which parameters: the name of the message that holds them, and of which copy, counted from 0.
struct ParametersId {
  std::string message{};
  std::uint8_t copy{};

  bool operator==(const ParametersId&) const = default;
};

/// "ReadParams3 of profile 2", "ReadProfileNames".
std::string to_text(const ParametersId& id);

/// Parameters as one message holds them, to the last byte.
struct Parameters {
  ParametersId id{};
  std::vector<std::uint8_t> body{};

  bool operator==(const Parameters&) const = default;
};

/// The parameters of a board, or some of them; each part can be decoded.
class ParameterSet {
 public:
  const std::vector<Parameters>& all() const noexcept { return blocks_; }
  const Parameters* find(const ParametersId& id) const noexcept;

  /// Takes a block in, in place of one with the same id. ErrorCode::invalid if no message holds
  /// such parameters, the body is none of that message, or it is about another copy.
  Result<void> put(Parameters block);

  /// The parameters of copy `copy`; ErrorCode::not_found if the set has none.
  template <ParameterMessage M>
  Result<M> get(std::uint8_t copy = 0) const {
    const Parameters* const block = find({SettingsOf<M>::name, copy});
    if (block == nullptr) return missing({SettingsOf<M>::name, copy});
    M message{};
    static_cast<void>(decode(std::span(block->body), message));  // put() has seen that it does
    return message;
  }

  /// Puts parameters in; the message says of which copy they are.
  template <ParameterMessage M>
  Result<void> set(const M& message) {
    std::uint8_t copy = 0;
    if constexpr (SettingsOf<M>::copies > 1) copy = SettingsOf<M>::copy(message);
    std::vector<std::uint8_t> body(max_body_size);
    body.resize(encode(message, body).size);
    return put({{SettingsOf<M>::name, copy}, std::move(body)});
  }

  bool operator==(const ParameterSet&) const = default;

 private:
  static ClientError missing(const ParametersId& id);

  std::vector<Parameters> blocks_{};
};

/// One field whose value differs. A missing field, of a shorter body, has an empty text.
struct FieldChange {
  std::string path{};  ///< "axes.roll.p"
  std::string before{};
  std::string after{};
  std::string before_meaning{};  ///< "-30 deg", "FOLLOW_MODE_FC", or ""
  std::string after_meaning{};

  bool operator==(const FieldChange&) const = default;
};

/// What differs within one block, or that only one side has it.
struct ParametersChange {
  enum class Kind : std::uint8_t { changed, only_before, only_after };

  ParametersId id{};
  Kind kind{};
  std::vector<FieldChange> fields{};

  bool operator==(const ParametersChange&) const = default;
};

/// The parameters in which two sets differ, field by field, in the order of `before`. State of the
/// board, such as the active profile, is no difference.
std::vector<ParametersChange> diff(const ParameterSet& before, const ParameterSet& after);

/// For people: a heading for each block, a line for each field; "" if there are none.
std::string to_text(const std::vector<ParametersChange>& changes);

/// How parameters are read.
struct ReadOptions {
  /// For all of it.
  std::chrono::milliseconds timeout{60'000};
  ProgressHandler progress{};
};

/// How parameters are written.
struct WriteOptions {
  /// For all of it.
  std::chrono::milliseconds timeout{120'000};
  /// Only tells what would be written.
  bool dry_run = false;
  /// Refuse what the protocol does not allow on this board in the fields that change, and general
  /// parameters that differ between wanted profiles but do not on the board.
  bool validate = true;
  ProgressHandler progress{};
};

/// What is known to stand on the board for one block that was to be written.
enum class ParametersState : std::uint8_t {
  equal,      ///< what was wanted stood there already
  written,    ///< it has been written and read back
  unwritten,  ///< what stood there before still does
  different,  ///< read back since: neither what was wanted nor what stood there before
  unknown,    ///< it has been sent, and could not be read back since
};

/// The name of a state, e.g. "written".
const char* name(ParametersState state) noexcept;

/// What became of one block.
struct ParametersReport {
  ParametersId id{};
  ParametersState state = ParametersState::unwritten;
  /// What was wanted to change, from the board's parameters before.
  std::vector<FieldChange> wanted{};
  /// How what stands there now differs from what was wanted, if it is ParametersState::different.
  std::vector<FieldChange> deviation{};
};

/// What write_parameters() has done, also if it has failed.
struct WriteReport {
  WriteReport() = default;
  /// Of what failed before anything was done.
  // NOLINTNEXTLINE(google-explicit-constructor): `return error;`
  WriteReport(ClientError error) : outcome(std::move(error)) {}

  /// Everything that was wanted stands on the board, or would after a dry run.
  Result<void> outcome{};
  std::vector<ParametersReport> parameters{};

  explicit operator bool() const noexcept { return static_cast<bool>(outcome); }
};

/// For people: the outcome, and what is known about each block.
std::string to_text(const WriteReport& report);

namespace tasks {

/// Reads all parameters that this board and firmware have.
Task<Result<ParameterSet>> read_parameters(ReadOptions options = {});

/// Makes the parameters of the board those in `wanted`. What `wanted` does not have stays.
///
/// All are read first; what can be found wrong is found before anything is written. Only
/// those that differ are written, each is confirmed and read back, and in the end all are read
/// once more. State of the board, and bytes that the board has behind the end of a wanted body,
/// are written back as they were read. Nothing is undone after a failure: the report says what
/// stands on the board.
Task<WriteReport> write_parameters(ParameterSet wanted, WriteOptions options = {});

}  // namespace tasks
}  // namespace sbgc
