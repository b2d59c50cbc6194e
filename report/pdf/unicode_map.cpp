#include "report/pdf/unicode_map.h"

#include <string>

#include <fmt/format.h>
#include <hpdf_objects.h>
#include <hpdf_streams.h>

namespace gabarit::pdf {

// A range may not run over the end of its last byte, and a block holds at most a hundred of them.
static std::string identity_map() {
  std::string map =
      "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n"
      "/CIDSystemInfo << /Registry (Adobe) /Ordering (UCS) /Supplement 0 >> def\n"
      "/CMapName /Adobe-Identity-UCS def\n/CMapType 2 def\n"
      "1 begincodespacerange\n<0000> <FFFF>\nendcodespacerange\n";
  constexpr int rows = 256, most_in_block = 64;
  for (int first = 0; first < rows; first += most_in_block) {
    map += fmt::format("{} beginbfrange\n", most_in_block);
    for (int row = first; row < first + most_in_block; ++row) {
      map += fmt::format("<{0:02X}00> <{0:02X}FF> <{0:02X}00>\n", row);
    }
    map += "endbfrange\n";
  }
  return map + "endcmap\nCMapName currentdict /CMap defineresource pop\nend\nend\n";
}

void repair_unicode_map(HPDF_Font font) {
  const auto map = static_cast<HPDF_Dict>(HPDF_Dict_GetItem(font, "ToUnicode", HPDF_OCLASS_DICT));
  if (map == nullptr || map->stream == nullptr) return;
  HPDF_MemStream_FreeData(map->stream);
  HPDF_Stream_WriteStr(map->stream, identity_map().c_str());
}

}  // namespace gabarit::pdf
