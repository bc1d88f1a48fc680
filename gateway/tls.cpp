#include "gateway/tls.hpp"

#include <algorithm>
#include <charconv>
#include <memory>

#include <fmt/format.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509.h>

#include "command/command_error.hpp"

namespace sbgc::tools {

namespace {

using TlsContext = std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)>;

TlsContext new_tls_context() {
  TlsContext context(SSL_CTX_new(TLS_client_method()), SSL_CTX_free);
  if (!context) throw std::bad_alloc();
  // Otherwise OpenSSL would ask on the terminal.
  SSL_CTX_set_default_passwd_cb(context.get(), [](char*, int, int, void*) { return 0; });
  ERR_clear_error();
  return context;
}

[[noreturn]] void reject_tls_file(const std::filesystem::path& file, const char* wanted) {
  const char* const reason = ERR_reason_error_string(ERR_peek_last_error());
  throw CommandError(fmt::format("{} is not {}: {}", file.string(), wanted,
                                 reason == nullptr ? "unknown error" : reason));
}

bool is_there_no_tls(int reason) {
  return reason == SSL_R_WRONG_VERSION_NUMBER || reason == SSL_R_HTTP_REQUEST ||
         reason == SSL_R_UNEXPECTED_EOF_WHILE_READING;
}

/// True for an alert about the client's certificate.
bool is_about_certificate(int alert) {
  return alert == SSL_AD_HANDSHAKE_FAILURE || alert == SSL_AD_CERTIFICATE_REQUIRED ||
         (alert >= SSL3_AD_NO_CERTIFICATE && alert <= SSL_AD_ACCESS_DENIED &&
          alert != SSL_AD_ILLEGAL_PARAMETER);
}

std::string own_certificate_advice(const BrokerSettings& settings) {
  return settings.certificate_file.empty()
             ? "a certificate of the gateway, 'certificate-file' and 'key-file'"
             : fmt::format("another certificate of the gateway than that in 'certificate-file', {}",
                           settings.certificate_file);
}

}  // namespace

void require_authorities(const std::filesystem::path& file) {
  const TlsContext context = new_tls_context();
  if (SSL_CTX_load_verify_locations(context.get(), file.c_str(), nullptr) == 1) return;
  reject_tls_file(file, "a file of certificates in PEM");
}

void require_certificate(const std::filesystem::path& file) {
  const TlsContext context = new_tls_context();
  if (SSL_CTX_use_certificate_chain_file(context.get(), file.c_str()) == 1) return;
  reject_tls_file(file, "a certificate in PEM");
}

void require_key(const std::filesystem::path& file, const std::filesystem::path& certificate) {
  const TlsContext context = new_tls_context();
  if (SSL_CTX_use_certificate_chain_file(context.get(), certificate.c_str()) == 1 &&
      SSL_CTX_use_PrivateKey_file(context.get(), file.c_str(), SSL_FILETYPE_PEM) == 1) {
    return;
  }
  reject_tls_file(file, "the key of the certificate, in PEM and without a passphrase");
}

void TlsLog::take(std::string_view line, long verified) {
  if (line.find("host name verification failed") != std::string_view::npos) is_other_host_ = true;
  // "OpenSSL Error[0]: error:0A000086:SSL routines::certificate verify failed"
  constexpr std::string_view mark = " error:";
  const std::size_t start = line.find(mark);
  if (start == std::string_view::npos || error_ != 0) return;
  verified_ = verified;
  line.remove_prefix(start + mark.size());
  constexpr int base = 16;
  std::from_chars(line.data(), line.data() + line.size(), error_, base);
  text_ = line.substr(line.rfind(':') + 1);
}

std::string TlsLog::reason(const BrokerAddress& address, const BrokerSettings& settings,
                           bool is_closed) const {
  const std::string at = fmt::format("{}:{}", address.host, address.port);
  if (is_other_host_ || verified_ != X509_V_OK) return certificate_problem(at, address, settings);
  if (error_ != 0) return handshake_problem(at, settings);
  if (!is_closed) return "";
  return settings.ca_file.empty()
             ? fmt::format(
                   "{} closes the connection before it answers: a broker with TLS needs "
                   "'ca-file'",
                   at)
             : fmt::format("{} closes the connection after the handshake of TLS: it may want {}",
                           at, own_certificate_advice(settings));
}

std::string TlsLog::certificate_problem(const std::string& at, const BrokerAddress& address,
                                        const BrokerSettings& settings) const {
  if (is_other_host_) {
    return fmt::format(
        "the certificate of {} is for another host: 'address' must be a name that it has, or it "
        "must have {}",
        at, address.host);
  }
  switch (verified_) {
    case X509_V_ERR_CERT_HAS_EXPIRED:
      return fmt::format(
          "the certificate of {}, or of its authority, has expired: the broker needs a new one, or "
          "this machine the right time",
          at);
    case X509_V_ERR_CERT_NOT_YET_VALID:
      return fmt::format(
          "the certificate of {}, or of its authority, is not valid yet: look at the clock of this "
          "machine",
          at);
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT:
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY:
    case X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE:
    case X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT:
    case X509_V_ERR_SELF_SIGNED_CERT_IN_CHAIN:
      return fmt::format(
          "the certificate of {} is from an authority that is not in 'ca-file', {}: add the "
          "certificate of the authority if you trust it",
          at, settings.ca_file);
    default:
      return fmt::format("the certificate of {} cannot be verified: {}", at,
                         X509_verify_cert_error_string(verified_));
  }
}

std::string TlsLog::handshake_problem(const std::string& at, const BrokerSettings& settings) const {
  const int reason = ERR_GET_REASON(error_);
  if (is_there_no_tls(reason)) {
    return fmt::format(
        "there is no TLS at {} ({}), which 'ca-file' turns on: a broker usually has it at the port "
        "8883",
        at, text_);
  }
  if (is_about_certificate(reason - SSL_AD_REASON_OFFSET)) {
    return fmt::format("{} wants {} ({})", at, own_certificate_advice(settings), text_);
  }
  return fmt::format("TLS with {} fails: {}", at, text_);
}

}  // namespace sbgc::tools
