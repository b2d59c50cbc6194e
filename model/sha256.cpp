#include "model/sha256.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

#include <openssl/evp.h>

namespace gabarit {

static void expect(int result) {
  if (result != 1) throw std::runtime_error("SHA-256 is not available in the installed libcrypto");
}

std::string sha256(std::span<const std::uint8_t> bytes, const std::stop_token& stop) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  expect(EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr));
  constexpr std::size_t piece = std::size_t{1} << 22;  // a few milliseconds
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    if (stop.stop_requested()) return {};
    const auto some = bytes.subspan(at, std::min(piece, bytes.size() - at));
    expect(EVP_DigestUpdate(context.get(), some.data(), some.size()));
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  expect(EVP_DigestFinal_ex(context.get(), digest.data(), &length));
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += digits[digest[i] >> 4U];
    text += digits[digest[i] & 15U];
  }
  return text;
}

std::string sha256(const std::string& text) {
  return sha256({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace gabarit
