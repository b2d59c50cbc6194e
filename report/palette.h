// The colours of the pictures. They differ in lightness as much as in hue, so that grey prints and
// colour-blind readers tell them apart, and the order is that of weight: what fails is darkest.
#pragma once

#include <optional>

#include "report/picture.h"
#include "rules/rule.h"

namespace gabarit {

// CIE lightness L* in brackets. Any two of the first four are more than 25 apart in CIELAB, also as seen with
// protanopia, deuteranopia and tritanopia (Machado, Oliveira & Fernandes 2009), and at least 8 in L*.
namespace palette {
inline constexpr Rgb fail{190, 20, 36};            // touched and too sharp (40)
inline constexpr Rgb pass{44, 154, 108};           // touched and round: a bluish green (57)
inline constexpr Rgb out_of_reach{178, 190, 202};  // not examined: blue-grey (76)
inline constexpr Rgb undecided{255, 209, 84};      // amber (86)
inline constexpr Rgb no_value{205, 196, 214};      // of a field, where there is no value
inline constexpr Rgb trace{28, 78, 150};           // the path of a probe, drawn as a line
}  // namespace palette

enum class ColourMap {
  by_limit,     // dark red to orange beyond the limit, pale yellow to blue within: L* alone tells the sides
                // apart
  sequential,   // viridis, dark is low; for fields without a limit
  red_to_blue,  // red is low, blue is high, over yellow and green, as in Inui, Umezu & Shimane
};

struct ColourScale {
  double low = 0, high = 1;    // values outside have the colours of the ends
  std::optional<Limit> limit;  // without one, by_limit shows as sequential
  ColourMap map = ColourMap::by_limit;

  Rgb colour(double value) const;  // palette::no_value for NaN
};

}  // namespace gabarit
