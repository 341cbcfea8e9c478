#include "keiko/inspect/basics/field_model.h"

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace keiko {
namespace {

/// Polynomial, rational with a pole, and rational with weights far from 1.
std::vector<SurfaceModel> models() {
    std::vector<SurfaceModel> all{
        test::bonnet_model(1200, 1400, 80),
        test::sphere_model(test::stretched({400, 500, 600}, {0.1, 0.2, 1}, {900, -20, 50}))};
    SurfaceModel weighted = test::bonnet_model(1200, 1400, 80);
    for (std::size_t i = 0; i < weighted.control_points.size(); ++i)
        weighted.control_points[i] *= 1 + 0.3 * static_cast<double>(i % 4);
    all.push_back(std::move(weighted));
    return all;
}

CPlane lamps_above() {
    CPlane lamps;
    lamps.origin = {-2000, -2000, 2500}, lamps.u = {4000, 100, 0}, lamps.v = {-100, 4000, 300};
    return lamps;
}

PatchBox random_box(const BezierPatchView& patch, int cuts, test::Random& random) {
    PatchBox box(patch);
    for (int i = 0; i < cuts; ++i)
        box = box.halves(test::pick(random, 2) == 0)[test::pick(random, 2)];
    return box;
}

bool holds(const TaylorModel& m, const Vec2& p, double value) {
    const double x = p.x, y = p.y;
    const double terms[] = {1,     x,         y,         x * x,     x * y,
                            y * y, x * x * x, x * x * y, x * y * y, y * y * y};
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < TaylorModel::count; ++i)
        sum += m.c[i] * terms[i], size += std::abs(m.c[i]);
    return std::abs(sum - value) <= m.error + 1e-13 * size;
}

using Derivatives = std::array<std::array<Vec4, 4>, 4>;

/// The derivatives of point times weight, and of the weight: those of two patches without weights.
Derivatives homogeneous_derivatives(const BezierPatchView& patch, const Vec2& uv) {
    std::vector<Vec4> points, weights;
    for (const Vec4& p : patch.points)
        points.emplace_back(p.x, p.y, p.z, 1), weights.emplace_back(p.w, 0, 0, 1);
    const SurfaceDerivatives p = evaluate({patch.degree_u, patch.degree_v, points}, uv, 2);
    const SurfaceDerivatives w = evaluate({patch.degree_u, patch.degree_v, weights}, uv, 2);
    Derivatives d{};
    for (std::size_t k = 0; k <= 2; ++k)
        for (std::size_t l = 0; k + l <= 2; ++l)
            d[k][l] = Vec4(p.d[k][l].x, p.d[k][l].y, p.d[k][l].z, w.d[k][l].x);
    return d;
}

/// A homogeneous coordinate of a derivative with its slopes by x and y, which run twice as far as
/// the box's parameters.
FirstJet jet_of(const Derivatives& d, std::size_t k, std::size_t l, int axis, const Vec2& half) {
    const double scale = std::pow(half.x, double(k)) * std::pow(half.y, double(l));
    return {d[k][l][axis] * scale, d[k + 1][l][axis] * scale * half.x,
            d[k][l + 1][axis] * scale * half.y};
}

/// The field and its slopes at a place, with the homogeneous place and normal that the model has.
LineRatio<FirstJet> exact(const BezierPatchView& patch, const Box2& box, const Vec2& uv,
                          const LineField& field, double shift) {
    const auto d = homogeneous_derivatives(patch, uv);
    const Vec2 half = box.extent() / 2;
    const auto triple = [&](std::size_t k, std::size_t l) {
        return Triple<FirstJet>{jet_of(d, k, l, 0, half), jet_of(d, k, l, 1, half),
                                jet_of(d, k, l, 2, half)};
    };
    const auto weight = [&](std::size_t k, std::size_t l) { return jet_of(d, k, l, 3, half); };
    const Triple<FirstJet> p = triple(0, 0), x = triple(1, 0), y = triple(0, 1);
    const Triple<FirstJet> normal =
        cross(x, y) * weight(0, 0) - cross(p, y) * weight(1, 0) - cross(x, p) * weight(0, 1);
    return field.ratio(p, normal, shift, weight(0, 0));
}

/// The search for lines rests on this: no value and no slope of the field leaves its model.
TEST(FieldModel, HoldsTheValuesAndSlopesOfEveryField) {
    test::Random random(8);
    Camera camera;
    for (const SurfaceModel& model : models())
        for (int i = 0; i < 300; ++i) {
            const BezierPatchView patch =
                model.patch(static_cast<std::uint32_t>(test::pick(random, model.patches.size())));
            const PatchBox box = random_box(patch, 1 + i % 12, random);
            for (const LineLook look :
                 {LineLook::reflection, LineLook::highlight, LineLook::isophote}) {
                const LineField field(look, LineEye(camera), lamps_above(), Vec3(0));
                const FieldModel bounds(box, field, 0.5);
                const LineRatio<Jet<TaylorModel>> sloped = bounds.sloped();
                const Jet<TaylorModel> f = sloped.residual(0.25);
                if (!std::isfinite(f.f.error)) continue;
                for (int k = 0; k < 4; ++k) {
                    const Vec2 at(test::uniform(random, -1, 1), test::uniform(random, -1, 1));
                    const Vec2 uv = box.uv().lower + (at + Vec2(1)) / 2 * box.uv().extent();
                    const LineRatio<FirstJet> real = exact(patch, box.uv(), uv, field, 0.5);
                    const FirstJet value = real.residual(0.25);
                    EXPECT_TRUE(holds(f.f, at, value.f)) << name_of(look);
                    EXPECT_TRUE(holds(f.u, at, value.u)) << name_of(look);
                    EXPECT_TRUE(holds(f.v, at, value.v)) << name_of(look);
                    EXPECT_TRUE(bounds.may_face_plane() || real.ahead.f < 0);
                }
            }
        }
}

/// No ray of a box that is left out meets the stretch of the C-plane.
TEST(FieldModel, LeavesOutBoxesWhoseRaysAllMissAStretch) {
    test::Random random(12);
    const CPlane lamps = lamps_above();
    CPlane exchanged = lamps;
    exchanged.u = lamps.v, exchanged.v = lamps.u;
    constexpr double low = 1200, high = 1900;
    int left_out = 0;
    for (const SurfaceModel& model : models())
        for (int i = 0; i < 300; ++i) {
            const BezierPatchView patch =
                model.patch(static_cast<std::uint32_t>(test::pick(random, model.patches.size())));
            const PatchBox box = random_box(patch, 3 + i % 8, random);
            for (const LineLook look : {LineLook::reflection, LineLook::highlight}) {
                const LineField field(look, LineEye(Camera{}), lamps, Vec3(0));
                const LineField other(look, LineEye(Camera{}), exchanged, Vec3(0));
                if (FieldModel(box, field, 0).may_meet(other, low, high)) continue;
                ++left_out;
                for (int k = 0; k < 20; ++k) {
                    const Vec2 at(test::uniform(random, 0, 1), test::uniform(random, 0, 1));
                    const Vec2 uv = box.uv().lower + at * box.uv().extent();
                    const LineRatio<FirstJet> real = exact(patch, box.uv(), uv, other, 0);
                    const double value = real.above.f / real.below.f;
                    EXPECT_TRUE(value < low || value > high || !(real.ahead.f > 0)) << value;
                }
            }
        }
    EXPECT_GT(left_out, 300);
}

/// Boxes with a pole may be singular, others soon are not.
TEST(FieldModel, SeesWhereTheNormalMayVanish) {
    const SurfaceModel sphere = test::sphere_model({});
    const LineField field(LineLook::reflection, LineEye(Camera{}), lamps_above(), Vec3(0));
    test::Random random(3);
    int regular = 0;
    for (std::uint32_t i = 0; i < sphere.patches.size(); ++i)
        for (int k = 0; k < 50; ++k) {
            const PatchBox box = random_box(sphere.patch(i), 8, random);
            const FieldModel model(box, field, 0);
            bool pole = false;
            for (const Vec2& uv : {box.uv().lower, box.uv().upper}) {
                const SurfaceDerivatives s = evaluate(sphere.patch(i), uv, 1);
                pole = pole || s.du().cross(s.dv()).length() < 1e-9 * s.du().length2();
            }
            if (pole) {
                EXPECT_TRUE(model.may_be_singular());
            }
            if (!model.may_be_singular()) ++regular;
        }
    EXPECT_GT(regular, 100);
}

} // namespace
} // namespace keiko
