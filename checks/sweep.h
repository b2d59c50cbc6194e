// The part of a disk's path that is left when it passes a vehicle from front to rear on either side.
#pragma once

#include "checks/disk_path.h"

namespace gabarit {

// The disk moves outwards freely and inwards no faster than rearwards (at most 45 degrees), as EU 44/2014
// Annex VIII 1.2 is read here: passing on the side of +y, a place c of the path stays when c.x + c.y is not
// less than at any place further forward, and alike on the other side. Sideways jumps in front of a part that
// faces forward stay. There is no median plane: a disk that comes inwards may cross it behind a part of one
// side, which can only add contacts. Pieces are cut to about 0.05 mm, generously.
DiskPath sweep_part(const DiskPath& path);

}  // namespace gabarit
