// PNG of a picture: for the web page of a report, and to look at.
#pragma once

#include <string>

#include "report/picture.h"

namespace gabarit {

// The bytes of a file: 8 bits a channel, sRGB, no time stamp. The picture has at least one pixel; throws
// std::runtime_error with libpng's reason.
std::string png_bytes(const Picture& picture);

}  // namespace gabarit
