// The parts of an assembly, placed and named.
#pragma once

#include <string>
#include <vector>

#include <TDocStd_Document.hxx>
#include <TopoDS_Shape.hxx>

namespace gabarit {

struct OcctPart {
  std::string name;    // UTF-8, never empty
  TopoDS_Shape shape;  // a solid, an open shell or a compound of loose faces; its placement is rigid
  bool solid = false;
};

// An empty document that the CAF readers fill.
Handle(TDocStd_Document) new_document();
// In the order of the document. A part is named after its product; solids that share a product,
// "product/solid name" where the file names them, else all alike. `fallback` names what has no name.
std::vector<OcctPart> parts(const Handle(TDocStd_Document) & document, const std::string& fallback);

}  // namespace gabarit
