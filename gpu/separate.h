// GABARIT_SEPARATE before a large function that is called from many places: compilers that copy it to each of
// them, as a kernel with everything inlined asks for, take minutes and gigabytes.
#pragma once

#define GABARIT_SEPARATE __attribute__((noinline))
