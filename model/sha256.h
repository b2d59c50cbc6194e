// SHA-256 (FIPS 180-4): names the exact bytes that a result relates to.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>

namespace gabarit {

// 64 lower-case hexadecimal digits; empty when it was asked to stop before the end.
std::string sha256(std::span<const std::uint8_t> bytes, const std::stop_token& stop = {});
std::string sha256(const std::string& text);

}  // namespace gabarit
