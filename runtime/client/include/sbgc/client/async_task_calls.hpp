/// All tasks as asynchronous operations.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <sbgc/client/tasks.hpp>

namespace sbgc {

/// `client.async_move_to(target, options, token)` is shorthand for
/// `client.async_run(tasks::move_to(target, options), token)`, and likewise for all other tasks.
/// The headers named below document them. Options may be left out, except those of async_restore().
template <class Self>
class AsyncTaskCalls {
 public:
  // Motion: <sbgc/client/motion.hpp>

  template <class Token>
  auto async_move_to(const MoveTarget& target, const MoveOptions& options, Token&& token) {
    return self().async_run(tasks::move_to(target, options), std::forward<Token>(token));
  }
  template <class Token>
  auto async_move_to(const MoveTarget& target, Token&& token) {
    return self().async_run(tasks::move_to(target), std::forward<Token>(token));
  }
  template <class Token>
  auto async_begin_move(const MoveTarget& target, const MoveOptions& options, Token&& token) {
    return self().async_run(tasks::begin_move(target, options), std::forward<Token>(token));
  }
  template <class Token>
  auto async_begin_move(const MoveTarget& target, Token&& token) {
    return self().async_run(tasks::begin_move(target), std::forward<Token>(token));
  }
  template <class Token>
  auto async_stop(const StopOptions& options, Token&& token) {
    return self().async_run(tasks::stop(options), std::forward<Token>(token));
  }
  template <class Token>
  auto async_stop(Token&& token) {
    return self().async_run(tasks::stop(), std::forward<Token>(token));
  }
  template <class Token>
  auto async_release(Token&& token) {
    return self().async_run(tasks::release(), std::forward<Token>(token));
  }
  template <class Token>
  auto async_set_control_timeout(std::chrono::milliseconds timeout, Token&& token) {
    return self().async_run(tasks::set_control_timeout(timeout), std::forward<Token>(token));
  }

  // Calibration: <sbgc/client/calibration.hpp>

  template <class Token>
  auto async_calibrate(Sensor sensor, const CalibrationOptions& options, Token&& token) {
    return self().async_run(tasks::calibrate(sensor, options), std::forward<Token>(token));
  }
  template <class Token>
  auto async_calibrate(Sensor sensor, Token&& token) {
    return self().async_run(tasks::calibrate(sensor), std::forward<Token>(token));
  }

  template <Message M, class Token>
  auto async_run_calibration(const M& request, const CalibrationOptions& options, Token&& token) {
    return self().async_run(tasks::run_calibration(request, options), std::forward<Token>(token));
  }
  template <Message M, class Token>
  auto async_run_calibration(const M& request, Token&& token) {
    return self().async_run(tasks::run_calibration(request), std::forward<Token>(token));
  }

  // Parameters: <sbgc/client/parameters.hpp>

  template <class Token>
  auto async_read_parameters(const ReadOptions& options, Token&& token) {
    return self().async_run(tasks::read_parameters(options), std::forward<Token>(token));
  }
  template <class Token>
  auto async_read_parameters(Token&& token) {
    return self().async_run(tasks::read_parameters(), std::forward<Token>(token));
  }
  template <class Token>
  auto async_write_parameters(const ParameterSet& wanted, const WriteOptions& options,
                              Token&& token) {
    return self().async_run(tasks::write_parameters(wanted, options), std::forward<Token>(token));
  }
  template <class Token>
  auto async_write_parameters(const ParameterSet& wanted, Token&& token) {
    return self().async_run(tasks::write_parameters(wanted), std::forward<Token>(token));
  }

  // Backups: <sbgc/client/backup.hpp>

  template <class Token>
  auto async_make_backup(const ReadOptions& options, Token&& token) {
    return self().async_run(tasks::make_backup(utc_now(), options), std::forward<Token>(token));
  }
  template <class Token>
  auto async_make_backup(Token&& token) {
    return self().async_run(tasks::make_backup(utc_now()), std::forward<Token>(token));
  }
  template <class Token>
  auto async_restore(const Backup& backup, const RestoreOptions& options, Token&& token) {
    return self().async_run(tasks::restore(backup, options), std::forward<Token>(token));
  }

  // Memory: <sbgc/client/memory.hpp>

  template <class Token>
  auto async_download_eeprom(std::uint32_t address, std::size_t size,
                             const TransferOptions& options, Token&& token) {
    return self().async_run(tasks::download_eeprom(address, size, options),
                            std::forward<Token>(token));
  }
  template <class Token>
  auto async_download_eeprom(std::uint32_t address, std::size_t size, Token&& token) {
    return self().async_run(tasks::download_eeprom(address, size), std::forward<Token>(token));
  }
  template <class Token>
  auto async_upload_eeprom(std::uint32_t address, std::vector<std::uint8_t> data,
                           const TransferOptions& options, Token&& token) {
    return self().async_run(tasks::upload_eeprom(address, std::move(data), options),
                            std::forward<Token>(token));
  }
  template <class Token>
  auto async_upload_eeprom(std::uint32_t address, std::vector<std::uint8_t> data, Token&& token) {
    return self().async_run(tasks::upload_eeprom(address, std::move(data)),
                            std::forward<Token>(token));
  }
  template <class Token>
  auto async_file_size(std::uint16_t file, Token&& token) {
    return self().async_run(tasks::file_size(file), std::forward<Token>(token));
  }
  template <class Token>
  auto async_download_file(std::uint16_t file, const TransferOptions& options, Token&& token) {
    return self().async_run(tasks::download_file(file, options), std::forward<Token>(token));
  }
  template <class Token>
  auto async_download_file(std::uint16_t file, Token&& token) {
    return self().async_run(tasks::download_file(file), std::forward<Token>(token));
  }
  template <class Token>
  auto async_upload_file(std::uint16_t file, std::vector<std::uint8_t> data,
                         const TransferOptions& options, Token&& token) {
    return self().async_run(tasks::upload_file(file, std::move(data), options),
                            std::forward<Token>(token));
  }
  template <class Token>
  auto async_upload_file(std::uint16_t file, std::vector<std::uint8_t> data, Token&& token) {
    return self().async_run(tasks::upload_file(file, std::move(data)), std::forward<Token>(token));
  }
  template <class Token>
  auto async_delete_file(std::uint16_t file, Token&& token) {
    return self().async_run(tasks::delete_file(file), std::forward<Token>(token));
  }
  template <class Token>
  auto async_delete_all_files(Token&& token) {
    return self().async_run(tasks::delete_all_files(), std::forward<Token>(token));
  }
  template <class Token>
  auto async_download_user_data(Token&& token) {
    return self().async_run(tasks::download_user_data(), std::forward<Token>(token));
  }
  template <class Token>
  auto async_upload_user_data(std::size_t offset, std::vector<std::uint8_t> data, Token&& token) {
    return self().async_run(tasks::upload_user_data(offset, std::move(data)),
                            std::forward<Token>(token));
  }

  // Profiles: <sbgc/client/profiles.hpp>

  template <class Token>
  auto async_active_profile(Token&& token) {
    return self().async_run(tasks::active_profile(), std::forward<Token>(token));
  }
  template <class Token>
  auto async_profile_names(Token&& token) {
    return self().async_run(tasks::profile_names(), std::forward<Token>(token));
  }
  template <class Token>
  auto async_rename_profile(std::size_t profile, std::string name, Token&& token) {
    return self().async_run(tasks::rename_profile(profile, std::move(name)),
                            std::forward<Token>(token));
  }
  template <class Token>
  auto async_rename_profiles(const ProfileNames& names, Token&& token) {
    return self().async_run(tasks::rename_profiles(names), std::forward<Token>(token));
  }

  // Adjustable variables: <sbgc/client/variables.hpp>

  template <class Token>
  auto async_get_variables(std::vector<std::string> names, Token&& token) {
    return self().async_run(tasks::get_variables(std::move(names)), std::forward<Token>(token));
  }
  template <class Token>
  auto async_get_variable(std::string name, Token&& token) {
    return self().async_run(tasks::get_variable(std::move(name)), std::forward<Token>(token));
  }
  template <class Token>
  auto async_set_variables(std::vector<VariableValue> values, Token&& token) {
    return self().async_run(tasks::set_variables(std::move(values)), std::forward<Token>(token));
  }
  template <class Token>
  auto async_set_variable(std::string name, double value, Token&& token) {
    return self().async_run(tasks::set_variable(std::move(name), value),
                            std::forward<Token>(token));
  }
  template <class Token>
  auto async_save_variables(Token&& token) {
    return self().async_run(tasks::save_variables(), std::forward<Token>(token));
  }

 protected:
  AsyncTaskCalls() = default;

 private:
  Self& self() noexcept { return static_cast<Self&>(*this); }
};

}  // namespace sbgc
