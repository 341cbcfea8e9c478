#include "keiko/inspect/openings/bodies.h"

#include "keiko/math/disjoint_sets.h"

namespace keiko {

Bodies::Bodies(const SurfaceModel& model, std::span<const Seam> seams) {
    const std::vector<PlacedFace> faces = placed_faces(model);
    for (std::size_t i = 0; i < faces.size(); ++i) of_[{faces[i].instance, faces[i].face}] = i;
    DisjointSets sets(faces.size());
    for (const Seam& seam : seams)
        sets.join(of({seam.a.instance, seam.a.face}), of({seam.b.instance, seam.b.face}));
    std::vector<std::size_t> body(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const std::size_t root = sets.root(i);
        if (root == i) body[i] = faces_.size(), faces_.emplace_back();
        body[i] = body[root];
        faces_[body[i]].push_back(faces[i]);
    }
    for (auto& [face, number] : of_) number = body[number];
}

} // namespace keiko
