#pragma once

#include "keiko/import/cad/loop_closing.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace keiko::cad {

/// Edges, numbered from 0 in the order they are met; two uses of one edge get one
/// number.
class EdgeTable {
public:
    std::uint32_t number_of(const TopoDS_Shape& edge) {
        return static_cast<std::uint32_t>(edges_.Add(edge)) - 1;
    }
    std::uint32_t count() const { return static_cast<std::uint32_t>(edges_.Extent()); }
    const TopoDS_Shape& edge(std::uint32_t number) const {
        return edges_(static_cast<int>(number) + 1);
    }

private:
    TopTools_IndexedMapOfShape edges_;
};

/// The trim loops of a face, in the parameters of its surface.
struct FaceLoops {
    std::vector<Chain> loops;
    Box2 domain;                          ///< what the patches must cover
    std::vector<std::uint32_t> edge_uses; ///< one entry a use, a seam twice
    RepairLog log;                        ///< what had to be repaired
};

/// Converts the wires of a face whose p-curves are complete; `built` are the edges whose were
/// fitted. Throws Error when a curve is missing.
FaceLoops face_loops(const TopoDS_Face& face, EdgeTable& edges,
                     const std::vector<TopoDS_Edge>& built);

} // namespace keiko::cad
