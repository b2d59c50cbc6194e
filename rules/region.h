// Which facets and edges a rule looks at: the tree of selectors evaluated on a model.
#pragma once

#include "rules/rule.h"

namespace gabarit {

// Three-valued over facets and edges. `all` hands the band that its direct `height` children leave (with
// those of the `all`s around it) to everything in it, so that a contact probe reaches exactly that far;
// `any` hands on what it got, `not` starts afresh. A depth survives `all` (the larger) and `any` (the
// smaller); under `not` there is none. Throws what a selector throws.
Region select(const Scene& scene, const Setup& setup, const Where& where);

// The same question in words, as the end of "facets where …"; such as "it reaches into a box and not it
// belongs to a body named `tank`".
std::string describe(const Where& where);

// Whether both ask the same of a model, whatever their places in the file.
bool same(const Where& a, const Where& b);

}  // namespace gabarit
