// What readers and searches take the letters of an embedded font for.
#pragma once

#include <hpdf.h>

namespace gabarit::pdf {

// libharu addresses glyphs by their Unicode but writes a map that is none by the PDF standard (9.10.3); this
// puts the identity in its place, so that text can be searched and copied.
void repair_unicode_map(HPDF_Font font);

}  // namespace gabarit::pdf
