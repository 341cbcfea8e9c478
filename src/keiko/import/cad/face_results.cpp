#include "keiko/import/cad/face_results.h"

#include "keiko/base/parallel.h"
#include "keiko/import/cad/face_check.h"
#include "keiko/import/cad/failure.h"
#include "keiko/import/cad/p_curves.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

namespace keiko::cad {
namespace {

std::vector<FaceResult> faces_of(const CadDocument& document) {
    std::vector<TopTools_IndexedMapOfShape> maps(document.parts.size());
    std::size_t count = 0;
    for (std::size_t p = 0; p < maps.size(); ++p) {
        TopExp::MapShapes(document.parts[p].shape, TopAbs_FACE, maps[p]);
        count += static_cast<std::size_t>(maps[p].Extent());
    }
    std::vector<FaceResult> faces(count);
    auto face = faces.begin();
    for (std::size_t p = 0; p < maps.size(); ++p)
        for (int i = 1; i <= maps[p].Extent(); ++i, ++face)
            face->shape = TopoDS::Face(maps[p](i)), face->part = p;
    return faces;
}

/// Tells the share of a stage that is itself a share of "import".
Job share_of(const Job& job, double from, double to) {
    Job share = job;
    if (job.progress)
        share.progress = [&job, from, to](const Progress& p) {
            job.report("import", from + (to - from) * p.fraction);
        };
    return share;
}

/// Loops that needed repair tell nothing of the wires they were made from.
KnownLoops known_loops(const FaceResult& face) {
    const bool whole = face.converted && face.converted->trim.loops.size() == 1 &&
                       face.converted->trim.log.empty();
    return whole && face.shape.NbChildren() == 1 && !face.shape.Infinite()
               ? KnownLoops::one_forward_loop
               : KnownLoops::nothing;
}

void convert(FaceResult& face, const std::vector<TopoDS_Edge>& built) {
    try {
        face.converted = convert_face(face.shape, face.edges, built);
    } catch (...) {
        face.loss = current_failure();
    }
    face.fault = fault_of(face.shape, known_loops(face));
}

} // namespace

std::vector<FaceResult> convert_faces(const CadDocument& document, const Job& job, double from,
                                      double to) {
    std::vector<FaceResult> faces = faces_of(document);
    std::vector<std::vector<TopoDS_Edge>> built;
    for (const FaceResult& face : faces) {
        job.check();
        built.push_back(complete_p_curves(face.shape));
    }
    parallel_for(faces.size(), share_of(job, from, to), "import",
                 [&](std::size_t i) { convert(faces[i], built[i]); });
    return faces;
}

} // namespace keiko::cad
