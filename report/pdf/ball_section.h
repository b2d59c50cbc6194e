// A section through the ball behind a worst value.
#pragma once

#include "report/pdf/book.h"
#include "report/worst_ball.h"

namespace gabarit::pdf {

// To scale: the cut material hatched (its outline alone where the mesh is open), the ball with its diameter,
// O and the contact C, and dashed the ball that the limit asks for; caption and scale bar below.
void draw_ball_section(Book& book, const Area& area, const RuleResult& result, const WorstBall& ball);

}  // namespace gabarit::pdf
