// The groups of parts. Drawn with x rearward from the front axle, y to the right, z up from the ground;
// millimetres.
#pragma once

#include "examples/motorcycle/part.h"

namespace gabarit::motorcycle {

void add_wheels(Parts& parts);
void add_front_end(Parts& parts);
void add_handlebar(Parts& parts);
void add_mirrors(Parts& parts);
void add_bodywork(Parts& parts);
void add_panels(Parts& parts);
void add_engine(Parts& parts);
void add_chassis(Parts& parts);
void add_footrests(Parts& parts);
void add_rear(Parts& parts);

inline constexpr double front_wheel_radius = 300, rear_wheel_radius = 315, wheelbase = 1420;

}  // namespace gabarit::motorcycle
