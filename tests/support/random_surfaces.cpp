#include "tests/support/random_surfaces.h"

#include <algorithm>
#include <cmath>

namespace keiko::test {
namespace {

/// Clamped knots over [0, 1] with spans - 1 inner ones, each 1 to degree times.
std::vector<double> random_knots(Random& random, int degree, int spans) {
    const auto ends = static_cast<std::size_t>(degree) + 1;
    std::vector<double> knots(ends, 0.0);
    for (int i = 1; i < spans; ++i) {
        const double place = (i + uniform(random, -0.3, 0.3)) / spans;
        knots.insert(knots.end(), 1 + pick(random, static_cast<std::size_t>(degree)), place);
    }
    knots.insert(knots.end(), ends, 1.0);
    return knots;
}

} // namespace

NurbsSurface random_nurbs(Random& random, const SurfaceKind& kind) {
    NurbsSurface surface{kind.degree_u,
                         kind.degree_v,
                         random_knots(random, kind.degree_u, kind.spans_u),
                         random_knots(random, kind.degree_v, kind.spans_v),
                         {}};
    const std::size_t rows = surface.count_u(), columns = surface.count_v();
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j) {
            const double w = std::exp(uniform(random, -0.5, 0.5) * std::log(kind.weights));
            const double u = static_cast<double>(i) / static_cast<double>(rows - 1);
            const double v = static_cast<double>(j) / static_cast<double>(columns - 1);
            const Vec3 noise(uniform(random, -1, 1), uniform(random, -1, 1),
                             uniform(random, -1, 1));
            const Vec3 p = kind.offset + noise * kind.rough +
                           Vec3(kind.length_u * (u - 0.5), 100 * (v - 0.5), 0);
            surface.points.emplace_back(p.x * w, p.y * w, p.z * w, w);
        }
    return surface;
}

std::vector<PatchData> patches_of(const NurbsSurface& surface) {
    std::vector<PatchData> patches;
    for (BezierPatchSpan& span : bezier_spans(surface)) {
        using Kind = ParameterMap::Kind;
        patches.push_back({surface.degree_u,
                           surface.degree_v,
                           std::move(span.points),
                           {Kind::affine, span.u_begin, span.u_end},
                           {Kind::affine, span.v_begin, span.v_end}});
    }
    return patches;
}

std::vector<LoopData> random_loops(Random& random) {
    const double left = uniform(random, 0, 0.1), right = uniform(random, 0.9, 1);
    const double low = uniform(random, 0, 0.1), high = uniform(random, 0.9, 1), round = 0.2;
    LoopData border{line({left, low}, {right, low}), line({right, low}, {right, high - round})};
    border.push_back({{Vec3(right, high - round, 1), Vec3(right, high, 1) * std::sqrt(0.5),
                       Vec3(right - round, high, 1)},
                      no_index});
    border.push_back(line({right - round, high}, {left, high}));
    border.push_back(line({left, high}, {left, low}));
    std::vector<LoopData> loops{border};
    for (const Vec2& middle : {Vec2(0.3, 0.3), Vec2(0.35, 0.7), Vec2(0.65, 0.4)})
        loops.push_back(circle(middle, uniform(random, 0.02, 0.15)));
    return loops;
}

Affine random_placement(Random& random, double shear) {
    Affine stretch{.rows = {Vec3(uniform(random, 0.5, 2), uniform(random, -shear, shear), 0),
                            Vec3(0, uniform(random, 0.5, 2), uniform(random, -shear, shear)),
                            Vec3(0, 0, uniform(random, 0.5, 2))}};
    if (random() % 2 == 0) stretch.rows[0] = -stretch.rows[0];
    const Vec3 away(uniform(random, -500, 500), uniform(random, -500, 500), 0);
    return Affine::translate(away) *
           Affine::rotate(random_direction(random), uniform(random, 0, 3)) * stretch;
}

SurfaceModel random_face(Random& random, const SurfaceKind& kind) {
    const std::vector<PatchData> patches = patches_of(random_nurbs(random, kind));
    ShapeBuilder builder;
    builder.face(patches, kind.trimmed ? random_loops(random) : std::vector<LoopData>{});
    if (kind.placed) builder.place({random_placement(random, kind.shear)});
    return builder.model();
}

} // namespace keiko::test
