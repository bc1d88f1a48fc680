/// Forward declarations of all tasks. To use one, include its header, such as
/// <sbgc/client/motion.hpp>.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <sbgc/client/result.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/types.hpp>

namespace sbgc {

namespace msg {
class Angle14;
}
struct Backup;
struct CalibrationOptions;
struct MoveOptions;
struct MoveProgress;
struct ProfileNames;
struct ReadOptions;
struct RestoreOptions;
struct StopOptions;
struct TransferOptions;
struct VariableValue;
struct WriteOptions;
struct WriteReport;
class ParameterSet;
enum class Sensor : std::uint8_t;

/// The targets of a move: {.pitch = -30_deg} moves one axis and leaves the others alone.
using MoveTarget = Axes<Optional<msg::Angle14>>;

/// Returns the current time of the host in the format of Backup::created.
std::string utc_now();

namespace tasks {

Task<Result<MoveProgress>> move_to(MoveTarget target, MoveOptions options);
Task<Result<void>> stop(StopOptions options);
Task<Result<void>> release();
Task<Result<void>> calibrate(Sensor sensor, CalibrationOptions options);
Task<Result<ParameterSet>> read_parameters(ReadOptions options);
Task<WriteReport> write_parameters(ParameterSet wanted, WriteOptions options);
Task<Result<Backup>> make_backup(std::string created, ReadOptions options);
Task<WriteReport> restore(Backup backup, RestoreOptions options);
Task<Result<std::vector<std::uint8_t>>> download_eeprom(std::uint32_t address, std::size_t size,
                                                        TransferOptions options);
Task<Result<void>> upload_eeprom(std::uint32_t address, std::vector<std::uint8_t> data,
                                 TransferOptions options);
Task<Result<std::size_t>> file_size(std::uint16_t file);
Task<Result<std::vector<std::uint8_t>>> download_file(std::uint16_t file, TransferOptions options);
Task<Result<void>> upload_file(std::uint16_t file, std::vector<std::uint8_t> data,
                               TransferOptions options);
Task<Result<void>> delete_file(std::uint16_t file);
Task<Result<void>> delete_all_files();
Task<Result<std::vector<std::uint8_t>>> download_user_data();
Task<Result<void>> upload_user_data(std::size_t offset, std::vector<std::uint8_t> data);
Task<Result<ProfileNames>> profile_names();
Task<Result<void>> rename_profile(std::size_t profile, std::string name);
Task<Result<void>> rename_profiles(ProfileNames names);
Task<Result<std::vector<double>>> get_variables(std::vector<std::string> names);
Task<Result<double>> get_variable(std::string name);
Task<Result<void>> set_variables(std::vector<VariableValue> values);
Task<Result<void>> set_variable(std::string name, double value);
Task<Result<void>> save_variables();

}  // namespace tasks

namespace detail {

/// T, as a dependent type: it needs to be complete only if the member of Self that names it is
/// used.
template <class Self, class T>
struct Dependent {
  using type = T;
};

}  // namespace detail
}  // namespace sbgc
