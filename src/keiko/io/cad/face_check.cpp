#include "keiko/io/cad/face_check.h"

#include "keiko/base/parallel.h"
#include "keiko/io/cad/part_conversion.h"

#include <BRepCheck_Analyzer.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

namespace keiko::cad {
namespace {

std::vector<TopoDS_Shape> faces_of(const CadDocument& document) {
    std::vector<TopoDS_Shape> faces;
    for (const CadPart& part : document.parts) {
        TopTools_IndexedMapOfShape map;
        TopExp::MapShapes(part.shape, TopAbs_FACE, map);
        for (int i = 1; i <= map.Extent(); ++i) faces.push_back(map(i));
    }
    return faces;
}

/// What is to be said of a face; empty for a valid one.
std::string fault_of(const TopoDS_Shape& face) {
    try {
        return BRepCheck_Analyzer(face).IsValid() ? ""
                                                  : "invalid in the file, says OpenCASCADE's check";
    } catch (...) {
        return "could not be checked: " + current_failure();
    }
}

} // namespace

Diagnostics invalid_faces(const CadDocument& document, const Job& job) {
    const std::vector<TopoDS_Shape> faces = faces_of(document);
    std::vector<std::string> faults(faces.size());
    constexpr std::size_t chunk = 16;
    parallel_for((faces.size() + chunk - 1) / chunk, job, "", [&](std::size_t task) {
        for (std::size_t i = task * chunk; i < std::min(faces.size(), (task + 1) * chunk); ++i)
            faults[i] = fault_of(faces[i]);
    });
    Diagnostics notes;
    for (std::size_t i = 0; i < faults.size(); ++i)
        if (!faults[i].empty())
            notes.push_back({Severity::note, "face " + std::to_string(i + 1), faults[i]});
    return notes;
}

} // namespace keiko::cad
