#include "keiko/base/error.h"
#include "keiko/import/cad/cad_files.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>

#include <fstream>

namespace keiko::cad {

CadDocument read_brep_file(const std::filesystem::path& path) {
    std::ifstream in(path);
    TopoDS_Shape shape;
    BRepTools::Read(shape, in, BRep_Builder());
    if (shape.IsNull()) throw Error(path.string(), "", "the BREP file is damaged or cut short");
    CadDocument document;
    document.parts.push_back({shape, path.stem().string(), {}});
    document.instances.push_back({0, path.stem().string(), {}});
    return document;
}

} // namespace keiko::cad
