/// Errors of TLS, in words. The library of MQTT reads the files, connects and verifies.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "gateway/fleet.hpp"

namespace sbgc::tools {

// Throw CommandError if the library could not use the file.

void require_authorities(const std::filesystem::path& file);
void require_certificate(const std::filesystem::path& file);
void require_key(const std::filesystem::path& file, const std::filesystem::path& certificate);

/// The log of the library about an attempt to connect.
class TlsLog {
 public:
  /// `verified` is what OpenSSL says of the certificate of the broker meanwhile.
  void take(std::string_view line, long verified);
  /// Returns why there is no connection, and what to do; "" if that is not known. `is_closed` if
  /// the broker has closed it before it answered.
  std::string reason(const BrokerAddress& address, const BrokerSettings& settings,
                     bool is_closed) const;

 private:
  std::string certificate_problem(const std::string& at, const BrokerAddress& address,
                                  const BrokerSettings& settings) const;
  std::string handshake_problem(const std::string& at, const BrokerSettings& settings) const;

  bool is_other_host_ = false;
  long verified_ = 0;
  unsigned long error_ = 0;  // of OpenSSL
  std::string text_{};       // of it
};

}  // namespace sbgc::tools
