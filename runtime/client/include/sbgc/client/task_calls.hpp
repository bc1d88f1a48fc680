/// All tasks as blocking member functions.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/calls.hpp>
#include <sbgc/client/tasks.hpp>

namespace sbgc {

/// `client.move_to(target, options)` is shorthand for `client.run(tasks::move_to(target,
/// options))`, and likewise for all other tasks. The headers named below document them. A task
/// hides a command of the protocol with the same name; call() can still send the command.
template <class Self>
class TaskCalls : public Calls<Self> {
 public:
  // Motion: <sbgc/client/motion.hpp>

  Result<MoveProgress> move_to(const MoveTarget& target, const MoveOptions& options = {}) {
    return self().run(tasks::move_to(target, options));
  }
  Result<MoveProgress> begin_move(const MoveTarget& target, const MoveOptions& options = {}) {
    return self().run(tasks::begin_move(target, options));
  }
  Result<void> stop(const StopOptions& options = {}) { return self().run(tasks::stop(options)); }
  Result<void> release() { return self().run(tasks::release()); }
  Result<void> set_control_timeout(std::chrono::milliseconds timeout) {
    return self().run(tasks::set_control_timeout(timeout));
  }

  // Calibration: <sbgc/client/calibration.hpp>

  Result<void> calibrate(Sensor sensor, const CalibrationOptions& options = {}) {
    return self().run(tasks::calibrate(sensor, options));
  }

  template <Callable M>
  Result<CalibrationEnd> run_calibration(const M& request, const CalibrationOptions& options = {}) {
    return self().run(tasks::run_calibration(request, options));
  }

  // Frequency responses: <sbgc/client/bode.hpp>

  Result<BodeRecording> record_bode(const msg::BodeTestStartStopRequest& request,
                                    const BodeOptions& options = {}) {
    return self().run(tasks::record_bode(request, options));
  }

  // Parameters: <sbgc/client/parameters.hpp>

  Result<ParameterSet> read_parameters(const ReadOptions& options = {}) {
    return self().run(tasks::read_parameters(options));
  }
  WriteReport write_parameters(const ParameterSet& wanted, const WriteOptions& options = {}) {
    return self().run(tasks::write_parameters(wanted, options));
  }

  // Backups: <sbgc/client/backup.hpp>

  Result<Backup> make_backup(const ReadOptions& options = {}) {
    return self().run(tasks::make_backup(utc_now(), options));
  }
  WriteReport restore(const Backup& backup, const RestoreOptions& options = {}) {
    return self().run(tasks::restore(backup, options));
  }

  // Memory: <sbgc/client/memory.hpp>

  Result<std::vector<std::uint8_t>> download_eeprom(std::uint32_t address, std::size_t size,
                                                    const TransferOptions& options = {}) {
    return self().run(tasks::download_eeprom(address, size, options));
  }
  Result<void> upload_eeprom(std::uint32_t address, std::vector<std::uint8_t> data,
                             const TransferOptions& options = {}) {
    return self().run(tasks::upload_eeprom(address, std::move(data), options));
  }
  Result<std::size_t> file_size(std::uint16_t file) { return self().run(tasks::file_size(file)); }
  Result<std::vector<std::uint8_t>> download_file(std::uint16_t file,
                                                  const TransferOptions& options = {}) {
    return self().run(tasks::download_file(file, options));
  }
  Result<void> upload_file(std::uint16_t file, std::vector<std::uint8_t> data,
                           const TransferOptions& options = {}) {
    return self().run(tasks::upload_file(file, std::move(data), options));
  }
  Result<void> delete_file(std::uint16_t file) { return self().run(tasks::delete_file(file)); }
  Result<void> delete_all_files() { return self().run(tasks::delete_all_files()); }
  Result<std::vector<std::uint8_t>> download_user_data() {
    return self().run(tasks::download_user_data());
  }
  Result<void> upload_user_data(std::size_t offset, std::vector<std::uint8_t> data) {
    return self().run(tasks::upload_user_data(offset, std::move(data)));
  }

  // Profiles: <sbgc/client/profiles.hpp>

  Result<std::size_t> active_profile() { return self().run(tasks::active_profile()); }
  Result<ProfileNames> profile_names() { return self().run(tasks::profile_names()); }
  Result<void> rename_profile(std::size_t profile, std::string name) {
    return self().run(tasks::rename_profile(profile, std::move(name)));
  }
  Result<void> rename_profiles(const ProfileNames& names) {
    return self().run(tasks::rename_profiles(names));
  }

  // Adjustable variables: <sbgc/client/variables.hpp>

  Result<std::vector<double>> get_variables(std::vector<std::string> names) {
    return self().run(tasks::get_variables(std::move(names)));
  }
  Result<double> get_variable(std::string name) {
    return self().run(tasks::get_variable(std::move(name)));
  }
  Result<void> set_variables(std::vector<VariableValue> values) {
    return self().run(tasks::set_variables(std::move(values)));
  }
  Result<void> set_variable(std::string name, double value) {
    return self().run(tasks::set_variable(std::move(name), value));
  }
  Result<void> save_variables() { return self().run(tasks::save_variables()); }

 protected:
  TaskCalls() = default;

 private:
  Self& self() noexcept { return static_cast<Self&>(*this); }
};

}  // namespace sbgc
