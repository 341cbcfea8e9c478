#include "keiko/compare/alignment/placed_model.h"

#include <algorithm>

namespace keiko {
namespace {

/// Adds copies of the patches of a face, moved; the trim curves are in face parameters and stay.
void place_patches(const SurfaceModel& from, const Face& face, const Affine& transform,
                   SurfaceModel& to) {
    for (std::uint32_t k = 0; k < face.patch_count; ++k) {
        Patch patch = from.patches[face.first_patch + k];
        const BezierPatchView view = from.patch(face.first_patch + k);
        patch.face = static_cast<std::uint32_t>(to.faces.size());
        patch.first_point = static_cast<std::uint32_t>(to.control_points.size());
        for (const Vec4& point : view.points)
            to.control_points.push_back(transform.homogeneous(point));
        to.patches.push_back(patch);
    }
}

} // namespace

PlacedModel placed_model(const SurfaceModel& model, const Affine& motion,
                         std::span<const std::uint32_t> chosen) {
    PlacedModel placed;
    SurfaceModel& to = placed.model;
    to.source = model.source, to.format = model.format, to.unit = model.unit;
    to.trim_points = model.trim_points, to.trim_curves = model.trim_curves;
    to.trim_loops = model.trim_loops, to.edges = model.edges;
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Affine transform = motion * model.instances[i].transform;
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
            if (!chosen.empty() && !std::binary_search(chosen.begin(), chosen.end(), f)) continue;
            Face face = model.faces[f];
            const auto first_patch = static_cast<std::uint32_t>(to.patches.size());
            place_patches(model, face, transform, to);
            face.part = 0, face.first_patch = first_patch;
            face.reversed = face.reversed != transform.mirrored();
            to.faces.push_back(std::move(face));
            placed.origin.push_back({i, f});
        }
    }
    to.parts.push_back({"", 0, static_cast<std::uint32_t>(to.faces.size())});
    to.instances.push_back({0, "", {}});
    return placed;
}

} // namespace keiko
