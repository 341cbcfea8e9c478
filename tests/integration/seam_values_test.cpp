#include "keiko/base/units.h"
#include "keiko/geometry/seam/border_run.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/seams/seam_probe.h"

#include "tests/integration/opencascade_tracer.h"
#include "tests/support/file_test_name.h"
#include "tests/support/paths.h"
#include <BRep_Tool.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Geom_Surface.hxx>
#include <LocalAnalysis_SurfaceContinuity.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace keiko {
namespace {

using namespace test;

gp_Dir direction(const Vec3& v) {
    return {v.x, v.y, v.z};
}

/// One side of a seam at one place, as OpenCASCADE has it.
struct PeerSide {
    Handle(Geom_Surface) surface;
    Vec2 uv;
    Vec3 across{0};    ///< unit, into the face and square to its border
    Vec3 normal{0};    ///< unit
    double rounding{}; ///< 1/mm: of curvature, where the surface is as it is here

    gp_Pnt position() const { return surface->Value(uv.x, uv.y); }
    /// 1/mm, of the section along `across` by the second fundamental form of OpenCASCADE's
    /// derivatives (its own directions of principal curvature are good to 1e-8 only); positive
    /// towards `up`.
    double curvature(const gp_Dir& up) const {
        GeomLProp_SLProps s(surface, uv.x, uv.y, 2, 1e-12);
        const double turn = s.Normal().Dot(up) < 0 ? -1 : 1;
        const gp_Vec n(s.Normal()), along(direction(across));
        const double e = s.D1U().SquareMagnitude(), f = s.D1U() * s.D1V(),
                     g = s.D1V().SquareMagnitude(), determinant = e * g - f * f;
        const double u = along * s.D1U(), v = along * s.D1V();
        const double a = (g * u - f * v) / determinant, b = (e * v - f * u) / determinant;
        return turn * (a * a * (s.D2U() * n) + 2 * a * b * (s.DUV() * n) + b * b * (s.D2V() * n));
    }
};

/// Seams of a file whose faces have loops, through Keiko and through OpenCASCADE's surfaces.
class SeamValues : public testing::TestWithParam<const char*> {
protected:
    void compare(const std::filesystem::path& file) {
        model_ = load_model(file);
        for (TopExp_Explorer e(read_shape(file), TopAbs_FACE); e.More(); e.Next())
            surfaces_.push_back(BRep_Tool::Surface(TopoDS::Face(e.Current())));
        ASSERT_EQ(surfaces_.size(), model_.faces.size());
        const BoundaryCurves curves(model_);
        constexpr std::size_t most = 1000;
        const std::vector<Seam> seams = pair_seams(model_, 0.5);
        for (std::size_t i = 0; i < seams.size(); i += 1 + seams.size() / most) {
            const Seam& seam = seams[i];
            if (seam.a.curve >= natural_side || seam.b.curve >= natural_side) continue;
            const SeamProbe probe(curves, seam);
            for (const double share : {0.07, 0.31, 0.5, 0.83})
                compare(curves, seam,
                        probe.at(probe.begin() + share * (probe.end() - probe.begin())));
        }
        std::cout << file.filename().string() << ": " << compared_ << " places, gap off by " << gap_
                  << " mm, angle by " << angle_ << " degrees, curvature by " << curvature_
                  << " of itself or 1 / size, beyond rounding\n";
        EXPECT_GE(compared_, 4);
    }

private:
    /// Keiko's face parameters are those of the file's surface.
    std::optional<PeerSide> side(const BoundaryCurves& curves, const BoundaryInterval& border,
                                 double t) const {
        const Vec2 uv = evaluate(model_.trim_curve(border.curve), t, 0)[0];
        const auto frame = curves.curve(border).frame(t);
        if (!frame) return {};
        const Patch& patch = model_.patches[curves.curve(border).patch_at(t)];
        PeerSide side{surfaces_[border.face], uv, frame->inward, frame->normal,
                      rounding(*frame, std::max(patch.degree_u, patch.degree_v))};
        const gp_Pnt there = side.position();
        const Vec3 off = Vec3(there.X(), there.Y(), there.Z()) - frame->position;
        const bool same = off.length() < 1e-9 * hull_bounds(model_).size();
        return same ? std::optional(side) : std::nullopt;
    }

    /// Error by rounding that both may have: second differences of coordinates over the square of a
    /// patch's edge.
    static double rounding(const BoundaryFrame& frame, int degree) {
        const double edge = std::min(frame.surface.du().length(), frame.surface.dv().length());
        constexpr double roundings = 64 * std::numeric_limits<double>::epsilon();
        return roundings * frame.position.length() * degree * degree / (edge * edge);
    }

    /// Sections square to the mean of the borders' directions, where these diverge by more than
    /// parallel_borders, as SeamPoint has it.
    static void share_direction(PeerSide& a, PeerSide& b) {
        const Vec3 along_a = a.normal.cross(a.across), along_b = b.normal.cross(b.across);
        if (along_a.cross(along_b).length() <= std::sin(parallel_borders)) return;
        const Vec3 mean = b.across - a.across;
        for (PeerSide* side : {&a, &b}) {
            const Vec3 in_face = mean - side->normal * mean.dot(side->normal);
            if (in_face.length() > mean.length() / 2) side->across = in_face.normalized();
        }
    }

    void compare(const BoundaryCurves& curves, const Seam& seam, const SeamPoint& ours) {
        auto a = side(curves, seam.a, ours.t), b = side(curves, seam.b, ours.s);
        if (!a || !b || !ours.angle || *ours.angle > 60) return;
        share_direction(*a, *b);
        const double wide = 10; // mm: gaps are compared, not judged
        LocalAnalysis_SurfaceContinuity peer(a->surface, a->uv.x, a->uv.y, b->surface, b->uv.x,
                                             b->uv.y, GeomAbs_G1, 1e-9, wide, wide, wide,
                                             degrees_to_radians(89), 1, 1);
        if (!peer.IsDone()) return;
        ++compared_;
        const double size = hull_bounds(model_).size();
        const double gap = std::abs(peer.C0Value() - ours.gap);
        const double angle = std::abs(peer.G1Angle() / degrees_to_radians(1) - *ours.angle);
        EXPECT_LE(gap, 1e-9 * size);
        EXPECT_LE(angle, 1e-8);
        gap_ = std::max(gap_, gap), angle_ = std::max(angle_, angle);
        compare_curvature(*a, *b, ours, size);
    }

    void compare_curvature(const PeerSide& a, const PeerSide& b, const SeamPoint& ours,
                           double size) {
        GeomLProp_SLProps properties(a.surface, a.uv.x, a.uv.y, 1, 1e-12);
        const gp_Dir normal = properties.Normal();
        const double ka = a.curvature(normal), kb = b.curvature(normal);
        const auto off = [&](double sign) {
            const auto relative = [&](double k, double peer, double rounding) {
                return std::max(0.0, std::abs(k - sign * peer) - rounding) /
                       std::max(std::abs(peer), 1 / size);
            };
            return std::max(relative(ours.curvature_a, ka, a.rounding),
                            relative(ours.curvature_b, kb, b.rounding));
        };
        const double least = std::min(off(1), off(-1));
        EXPECT_LE(least, 1e-9) << ka << ' ' << ours.curvature_a << ", " << kb << ' '
                               << ours.curvature_b;
        curvature_ = std::max(curvature_, least);
    }

    SurfaceModel model_;
    std::vector<Handle(Geom_Surface)> surfaces_;
    int compared_ = 0;
    double gap_ = 0, angle_ = 0, curvature_ = 0;
};

class SharedSeamValues : public SeamValues {};

TEST_P(SeamValues, AgreeWithLocalAnalysis) {
    compare(repository("surfaces") / GetParam());
}

TEST_P(SharedSeamValues, AgreeWithLocalAnalysis) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    compare(shared_model(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Surfaces, SeamValues,
                         testing::Values("concept-car.step", "hood.step", "seam-g1-angle.step"),
                         file_test_name);

INSTANTIATE_TEST_SUITE_P(Panels, SharedSeamValues,
                         testing::Values("car-hood.brep", "car-front-fender.brep",
                                         "car-rear-deck-half-panel.brep",
                                         "die-cast-housing-degree-5.step"),
                         file_test_name);

} // namespace
} // namespace keiko
