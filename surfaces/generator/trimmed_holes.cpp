#include "face_maker.h"
#include "fixtures.h"
#include "trimmed_skin.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko::fixtures {
namespace {

constexpr double kSize = 200.0;
constexpr double kRadiusX = 900.0;
constexpr double kRadiusY = 600.0;

/// A circle in plan view, in mm.
struct Circle {
    double x;
    double y;
    double radius;
};

/// One biquadratic patch, x and y growing evenly with u and v, so that a circle in plan view is a
/// circle in (u, v) too.
Skin plate() {
    const Net net = polynomial_net(2, 2, [](double u, double v) {
        const double x = kSize * (u - 0.5);
        const double y = kSize * (v - 0.5);
        return gp_XYZ(x, y, -x * x / (2.0 * kRadiusX) - y * y / (2.0 * kRadiusY));
    });
    return Skin(1, 1, false, [&](Cell) { return net; });
}

/// Counter-clockwise, a piece each quarter.
TrimCurve outline(const Skin& skin, const Circle& circle) {
    const TrimPath path = [&](double tau, const TrimPoint&) {
        const gp_XY uv(0.5 + (circle.x + circle.radius * std::cos(tau)) / kSize,
                       0.5 + (circle.y + circle.radius * std::sin(tau)) / kSize);
        return TrimPoint{skin.evaluate(uv).position, {uv}};
    };
    TrimCurve curve;
    for (int k = 0; k < 4; ++k) {
        const double quarter = 0.5 * std::numbers::pi;
        const TrimCurve part = trace(path, quarter * k, quarter * (k + 1), {}, {&skin});
        curve.insert(curve.end(), part.begin(), part.end());
    }
    return curve;
}

/// The edges' distance from the circle's axis where it is furthest from the radius.
double measured_radius(const TrimCurve& curve, const Circle& circle) {
    double worst = circle.radius;
    for (const TrimPiece& piece : curve)
        for (double t = 0.05; t < 1.0; t += 0.1) {
            const gp_XYZ p = point_on(piece, t);
            const double radius = std::hypot(p.X() - circle.x, p.Y() - circle.y);
            if (std::abs(radius - circle.radius) > std::abs(worst - circle.radius)) worst = radius;
        }
    return worst;
}

GroundTruth radius_truth(const TrimCurve& curve, const Circle& circle) {
    const auto whole = [](double value) { return std::to_string(std::lround(value)); };
    return {"radius of the circle about (" + whole(circle.x) + ", " + whole(circle.y) + ")", "mm",
            circle.radius, measured_radius(curve, circle), 1e-6};
}

/// The plate without the discs of `holes`, and the disc `island` (if its radius is not 0).
Fixture plate_fixture(const std::string& file, const std::vector<Circle>& holes,
                      const Circle& island) {
    const Skin skin = plate();
    std::vector<TrimCurve> curves;
    for (const Circle& hole : holes) curves.push_back(outline(skin, hole));
    const TrimCurve island_curve = island.radius > 0.0 ? outline(skin, island) : TrimCurve{};
    Fixture fixture{file, {}, {}};
    ShapePool pool;
    Region rest{"plate", {}, [](Cell) { return true; }};
    for (std::size_t k = 0; k < holes.size(); ++k) {
        rest.boundaries.push_back({&curves[k], 0, true});
        fixture.truths.push_back(radius_truth(curves[k], holes[k]));
    }
    TrimmedSkin trimmed(skin, rest.boundaries, true, pool);
    fixture.faces = trimmed.faces(rest);
    if (!island_curve.empty()) {
        const Region disc{"island", {{&island_curve, 0}}, [](Cell) { return false; }};
        fixture.faces.push_back(trimmed.faces(disc).front());
        fixture.truths.push_back(radius_truth(island_curve, island));
    }
    return fixture;
}

constexpr Circle kNoIsland{0.0, 0.0, 0.0};

} // namespace

Fixture trimmed_hole() {
    return plate_fixture("trimmed-hole.step", {{10.0, -5.0, 40.0}}, kNoIsland);
}

Fixture trimmed_two_holes() {
    return plate_fixture("trimmed-two-holes.step", {{-40.0, 10.0, 30.0}, {50.0, -20.0, 15.0}},
                         kNoIsland);
}

Fixture trimmed_island() {
    return plate_fixture("trimmed-island.step", {{0.0, 0.0, 60.0}}, {10.0, 0.0, 25.0});
}

} // namespace keiko::fixtures
