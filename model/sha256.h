// SHA-256 (FIPS 180-4): names the exact bytes that a result relates to.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace gabarit {

// 64 lower-case hexadecimal digits.
std::string sha256(std::span<const std::uint8_t> bytes);
std::string sha256(const std::string& text);

}  // namespace gabarit
