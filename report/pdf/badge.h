// A verdict as a reader finds it without colour: a sign of its own shape, and a word.
#pragma once

#include "report/pdf/canvas.h"
#include "rules/verdict.h"

namespace gabarit::pdf {

// "PASS", "FAIL", "UNDECIDED", "NOT APPLICABLE", "NOT RUN".
const char* verdict_word(Verdict verdict);
Rgb verdict_colour(Verdict verdict);

// ✓ ✗ ? – or a broken circle, drawn and not written: no font needs to have it. `size` mm wide.
void draw_sign(Canvas& canvas, Place centre, double size, Verdict verdict, Rgb colour);

// A sign and a word, its baseline at `at`.
void draw_small_badge(Canvas& canvas, Place at, Verdict verdict);
// A filled plate across `area` with the sign and the word in white.
void draw_plate(Canvas& canvas, const Area& area, Verdict verdict);

}  // namespace gabarit::pdf
