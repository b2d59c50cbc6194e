// Darkens corners and the foot of steps, where less light would get to: it tells near from far.
#pragma once

#include "gpu/device.h"
#include "report/render/film.h"

namespace gabarit {

// The finished picture. A pixel is darkened by how deep it lies under the middle of pairs of pixels opposite
// each other around it, on six rings up to 23 pixels away (in the spirit of Mittring, Finding next gen,
// 2007); surfaces much nearer than the ring is wide hang free and do not count.
Picture developed(const Film& film, bool occlusion, const Device& device);

}  // namespace gabarit
