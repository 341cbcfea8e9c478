#include "keiko/base/error.h"
#include "keiko/import/subdivision/limit_table.h"

#include <opensubdiv/far/topologyDescriptor.h>

namespace keiko::subdivision {
namespace {

osd::Sdc::Options options_of(const Cage& cage) {
    using Options = osd::Sdc::Options;
    Options options;
    options.SetVtxBoundaryInterpolation(
        cage.boundary == BoundaryRule::none        ? Options::VTX_BOUNDARY_NONE
        : cage.boundary == BoundaryRule::edge_only ? Options::VTX_BOUNDARY_EDGE_ONLY
                                                   : Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    options.SetCreasingMethod(cage.crease_method == CreaseMethod::chaikin
                                  ? Options::CREASE_CHAIKIN
                                  : Options::CREASE_UNIFORM);
    options.SetTriangleSubdivision(cage.triangles == TriangleRule::smooth
                                       ? Options::TRI_SUB_SMOOTH
                                       : Options::TRI_SUB_CATMARK);
    return options;
}

/// The cage's lists in the types of OpenSubdiv.
struct Lists {
    std::vector<int> face_sizes, corners, holes, crease_ends, sharp_corners;
    std::vector<float> crease_sharpness, corner_sharpness;

    explicit Lists(const Cage& cage) : corners(cage.corners.begin(), cage.corners.end()) {
        for (std::size_t f = 0; f < cage.faces.size(); ++f) {
            face_sizes.push_back(static_cast<int>(cage.faces[f].corner_count));
            if (cage.faces[f].hole) holes.push_back(static_cast<int>(f));
        }
        for (const CageCrease& crease : cage.creases) {
            crease_ends.push_back(static_cast<int>(crease.a));
            crease_ends.push_back(static_cast<int>(crease.b));
            crease_sharpness.push_back(static_cast<float>(crease.sharpness));
        }
        for (const CageCorner& corner : cage.sharp_corners) {
            sharp_corners.push_back(static_cast<int>(corner.vertex));
            corner_sharpness.push_back(static_cast<float>(corner.sharpness));
        }
    }
};

int size_of(const auto& list) {
    return static_cast<int>(list.size());
}

} // namespace

std::unique_ptr<osd::Far::TopologyRefiner> make_refiner(const Cage& cage) {
    const Lists lists(cage);
    osd::Far::TopologyDescriptor topology;
    topology.numVertices = size_of(cage.vertices);
    topology.numFaces = size_of(cage.faces);
    topology.numVertsPerFace = lists.face_sizes.data();
    topology.vertIndicesPerFace = lists.corners.data();
    topology.numCreases = size_of(lists.crease_sharpness);
    topology.creaseVertexIndexPairs = lists.crease_ends.data();
    topology.creaseWeights = lists.crease_sharpness.data();
    topology.numCorners = size_of(lists.sharp_corners);
    topology.cornerVertexIndices = lists.sharp_corners.data();
    topology.cornerWeights = lists.corner_sharpness.data();
    topology.numHoles = size_of(lists.holes);
    topology.holeIndices = lists.holes.data();

    using Factory = osd::Far::TopologyRefinerFactory<osd::Far::TopologyDescriptor>;
    const auto scheme =
        cage.scheme == Scheme::loop ? osd::Sdc::SCHEME_LOOP : osd::Sdc::SCHEME_CATMARK;
    std::unique_ptr<osd::Far::TopologyRefiner> refiner(
        Factory::Create(topology, Factory::Options(scheme, options_of(cage))));
    if (!refiner) throw Error("", "", "OpenSubdiv does not accept the cage");
    return refiner;
}

} // namespace keiko::subdivision
