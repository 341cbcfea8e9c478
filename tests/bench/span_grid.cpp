#include "tests/bench/span_grid.h"

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/math/nearest_rank.h"

#include "tests/bench/cpu_clock.h"

#include <cmath>
#include <utility>

namespace keiko::bench {
namespace {

/// A vertex' parameter, moved off a border where the tangents vanish.
Vec3 normal_at(const BezierPatchView& patch, const Affine& map, Vec2 uv) {
    constexpr double aside = 1e-6;
    for (int attempt = 0; attempt < 2; ++attempt) {
        const SurfaceDerivatives s = evaluate(patch, uv, 1);
        const Vec3 n = map.vector(s.du()).cross(map.vector(s.dv()));
        if (n.length() > 1e-9 * s.du().length() * s.dv().length()) return n.normalized();
        uv = uv * (1 - 2 * aside) + Vec2(aside);
    }
    return {0, 0, 1};
}

class GridBuilder {
public:
    GridBuilder(const SurfaceModel& model, int n, const Vec3& center)
        : model_(model), n_(n), center_(center) {
        for (const Face& face : model.faces) regions_.emplace_back(model, face);
    }

    void append(const Affine& map, std::uint32_t patch) {
        const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
        const BezierPatchView view = model_.patch(patch);
        for (int i = 0; i <= n_; ++i)
            for (int j = 0; j <= n_; ++j) {
                const Vec2 uv = Vec2(i, j) / n_;
                mesh_.positions.emplace_back(map.point(evaluate(view, uv, 0).position()) - center_);
                mesh_.normals.emplace_back(normal_at(view, map, uv));
            }
        for (int i = 0; i < n_; ++i) probe(map, view, first, i);
        const TrimRegion& region = regions_[model_.patches[patch].face];
        const auto row = static_cast<std::uint32_t>(n_ + 1);
        for (std::uint32_t i = 0; i + 1 < row; ++i)
            for (std::uint32_t j = 0; j + 1 < row; ++j) {
                const Vec2 centre = Vec2(i + 0.5, j + 0.5) / n_;
                if (!region.contains(model_.face_parameters(patch, centre))) continue;
                const std::uint32_t corner = first + i * row + j;
                mesh_.triangles.push_back({corner, corner + row, corner + row + 1});
                mesh_.triangles.push_back({corner, corner + row + 1, corner + 1});
            }
    }

    TriangleMesh finish() {
        mesh_.deviation = nearest_rank(deviations_, 0.999);
        mesh_.positions.emplace_back(0.0F);
        return std::move(mesh_);
    }

private:
    /// How far the middle of cell (i, i) is off the plane of its first triangle.
    void probe(const Affine& map, const BezierPatchView& view, std::uint32_t first, int i) {
        const auto row = static_cast<std::uint32_t>(n_ + 1);
        const std::uint32_t corner = first + static_cast<std::uint32_t>(i) * (row + 1);
        const Vec3 a(mesh_.positions[corner]), b(mesh_.positions[corner + row]),
            c(mesh_.positions[corner + row + 1]);
        const Vec3 normal = (b - a).cross(c - a).normalized();
        const Vec3 middle = map.point(evaluate(view, Vec2(i + 0.5) / n_, 0).position()) - center_;
        deviations_.push_back(std::abs((middle - a).dot(normal)));
    }

    const SurfaceModel& model_;
    int n_;
    Vec3 center_;
    std::vector<TrimRegion> regions_; ///< one a face
    TriangleMesh mesh_;
    std::vector<double> deviations_; ///< mm
};

template <class Visit>
void for_each_placed_patch(const SurfaceModel& model, const Visit& visit) {
    for (const Instance& instance : model.instances)
        for (std::uint32_t p = 0; p < model.patches.size(); ++p)
            if (model.faces[model.patches[p].face].part == instance.part)
                visit(instance.transform, p);
}

} // namespace

TriangleMesh span_grid(const SurfaceModel& model, int n, const Vec3& center) {
    TriangleMesh mesh;
    const double seconds = process_seconds([&] {
        GridBuilder builder(model, n, center);
        for_each_placed_patch(
            model, [&](const Affine& map, std::uint32_t patch) { builder.append(map, patch); });
        mesh = builder.finish();
    });
    mesh.mesh_seconds = seconds;
    return mesh;
}

int finest_span_grid(const SurfaceModel& model, std::size_t most_triangles) {
    double patches = 0;
    for_each_placed_patch(model, [&](const Affine&, std::uint32_t) { ++patches; });
    return static_cast<int>(std::sqrt(static_cast<double>(most_triangles) / 2 / patches));
}

} // namespace keiko::bench
