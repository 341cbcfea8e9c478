#pragma once

#include "keiko/base/job.h"
#include "keiko/import/cad/cad_document.h"
#include "keiko/import/cad/surface_patches.h"
#include "keiko/import/cad/trim_chains.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <optional>
#include <string>
#include <vector>

namespace keiko::cad {

/// Edges, numbered from 0 in the order they are met; two uses of one edge get one
/// number.
class EdgeTable {
public:
    /// Number of an edge, which is added if it is new.
    std::uint32_t number_of(const TopoDS_Shape& edge) {
        return static_cast<std::uint32_t>(edges_.Add(edge)) - 1;
    }
    /// Number of different edges.
    std::uint32_t count() const { return static_cast<std::uint32_t>(edges_.Extent()); }
    /// Edge of a number below count().
    const TopoDS_Shape& edge(std::uint32_t number) const {
        return edges_(static_cast<int>(number) + 1);
    }

private:
    TopTools_IndexedMapOfShape edges_;
};

/// The trim loops of a face, in the parameters of its surface.
struct FaceLoops {
    std::vector<Chain> loops;             ///< closed; the even-odd rule gives the material
    Box2 domain;                          ///< what the patches must cover
    std::vector<std::uint32_t> edge_uses; ///< one entry a use, a seam twice
    RepairLog log;                        ///< what had to be repaired
};

/// Converts the wires of a face whose p-curves are complete; `built` are the edges whose were
/// fitted. Throws Error when a curve is missing.
FaceLoops face_loops(const TopoDS_Face& face, EdgeTable& edges,
                     const std::vector<TopoDS_Edge>& built);

/// A CAD face as rational Bezier patches and trim loops, in the coordinates of its part.
struct ConvertedFace {
    std::vector<SurfacePatch> patches; ///< that cover the domain of the loops
    double approximated = 0;           ///< mm; 0 where exact
    FaceLoops trim;                    ///< of the wires
};

/// Converts a face (as face_loops its wires) and checks the patches against the CAD surface. Throws
/// Error (or what OpenCASCADE throws) when the face cannot be converted.
ConvertedFace convert_face(const TopoDS_Face& face, EdgeTable& edges,
                           const std::vector<TopoDS_Edge>& built);

/// "plane", "b-spline", ... of a face's surface.
std::string surface_kind(const TopoDS_Face& face);

/// A face of a document and what became of it.
struct FaceResult {
    TopoDS_Face shape;                      ///< as the document has it
    std::size_t part = 0;                   ///< into CadDocument::parts
    EdgeTable edges;                        ///< those of the face, in the order they were met
    std::optional<ConvertedFace> converted; ///< nullopt: the face is lost
    std::string loss;                       ///< why there is none
    std::string fault; ///< what OpenCASCADE's own check has against the face; mostly empty
};

/// Converts and checks all faces, part by part, many at a time. Progress goes to `job` as "import",
/// from one share of it to another.
std::vector<FaceResult> convert_faces(const CadDocument& document, const Job& job, double from,
                                      double to);

/// The reason of the exception being handled, one line. Lack of memory is thrown on: it is not
/// the fault of one face.
std::string current_failure();

/// Knowledge of a face's loops before its check.
enum class KnownLoops {
    nothing,         ///< the wires may be anything
    one_forward_loop ///< one wire that is one loop, closed as it stands, its material on the left
};

/// Fault that OpenCASCADE's own check finds in a face by itself, a hint when a picture is odd;
/// empty for a valid face. Finds what BRepCheck_Analyzer finds on the face, but stops at the first
/// fault. The direction of a loop that is known to run forward is not tested: classifying it costs
/// more than all the rest. Several threads may check faces that share edges.
std::string fault_of(const TopoDS_Face& face, KnownLoops known);

} // namespace keiko::cad
