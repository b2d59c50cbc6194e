// Text made safe for XML 1.0.
#pragma once

#include <string>

namespace gabarit {

// Markup is escaped; what XML cannot hold (control characters, bytes that are not UTF-8) becomes U+FFFD.
std::string xml_text(const std::string& text);

}  // namespace gabarit
