// OpenSSL's own SHA-256, not by way of its providers: linked statically, those bring 4 MB.
#define OPENSSL_API_COMPAT 0x10100000L

#include "model/sha256.h"

#include <algorithm>
#include <array>

#include <openssl/sha.h>

namespace gabarit {

std::string sha256(std::span<const std::uint8_t> bytes, const std::stop_token& stop) {
  SHA256_CTX context;
  SHA256_Init(&context);
  constexpr std::size_t piece = std::size_t{1} << 22;  // a few milliseconds
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    if (stop.stop_requested()) return {};
    const auto some = bytes.subspan(at, std::min(piece, bytes.size() - at));
    SHA256_Update(&context, some.data(), some.size());
  }
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256_Final(digest.data(), &context);
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) {
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return text;
}

std::string sha256(const std::string& text) {
  return sha256({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace gabarit
