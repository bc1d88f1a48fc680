/// TLS errors in words. The MQTT library reads the files, connects and verifies.
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

/// The library's log of an attempt to connect.
class TlsLog {
 public:
  /// `verified` is OpenSSL's verification result for the certificate of the broker.
  void take(std::string_view line, long verified);
  /// Returns the reason of the failure, and a remedy; "" if unknown. `is_closed` if the broker has
  /// closed the connection before it answered.
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
