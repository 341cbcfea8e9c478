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

namespace {

/// Appends a copy of a curve's points; the edge that it belonged to is not kept.
TrimCurve copied(const SurfaceModel& from, TrimCurve curve, SurfaceModel& to) {
    const auto first = from.trim_points.begin() + curve.first_point;
    curve.first_point = static_cast<std::uint32_t>(to.trim_points.size());
    curve.edge = no_index;
    to.trim_points.insert(to.trim_points.end(), first, first + curve.degree + 1);
    return curve;
}

void add_patches(const SurfaceModel& from, Face& face, SurfaceModel& to) {
    const std::uint32_t first = face.first_patch;
    face.first_patch = static_cast<std::uint32_t>(to.patches.size());
    for (std::uint32_t i = first; i < first + face.patch_count; ++i) {
        Patch patch = from.patches[i];
        const auto points = from.patch(i).points;
        patch.face = static_cast<std::uint32_t>(to.faces.size());
        patch.first_point = static_cast<std::uint32_t>(to.control_points.size());
        to.control_points.insert(to.control_points.end(), points.begin(), points.end());
        to.patches.push_back(patch);
    }
}

void add_loops(const SurfaceModel& from, Face& face, SurfaceModel& to) {
    const auto loops = from.loops_of(face);
    face.first_loop = static_cast<std::uint32_t>(to.trim_loops.size());
    for (const TrimLoop& loop : loops) {
        to.trim_loops.push_back(
            {static_cast<std::uint32_t>(to.trim_curves.size()), loop.curve_count});
        for (const TrimCurve& curve : from.curves_of(loop))
            to.trim_curves.push_back(copied(from, curve, to));
    }
}

} // namespace

SurfaceModel placed_subset(const SurfaceModel& model, std::span<const PlacedFace> faces) {
    SurfaceModel subset;
    subset.source = model.source, subset.format = model.format;
    for (const PlacedFace& of : faces) {
        const auto number = static_cast<std::uint32_t>(subset.faces.size());
        Face face = model.faces[of.face];
        face.part = number;
        add_patches(model, face, subset);
        add_loops(model, face, subset);
        subset.faces.push_back(face);
        subset.parts.push_back({"", number, 1});
        subset.instances.push_back({number, "", model.instances[of.instance].transform});
    }
    return subset;
}

} // namespace keiko
