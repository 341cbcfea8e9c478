#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/import/worker/load_model.h"

#include "tests/integration/opencascade_tracer.h"
#include "tests/support/analytic_models.h"
#include "tests/support/file_test_name.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"
#include <BRepAdaptor_Surface.hxx>
#include <BRepLProp_SLProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr int place_count = 10000; // a model
constexpr double share = 1e-9;     // of the larger of the curvature and 1 / size

struct Place {
    std::uint32_t patch = 0;
    Vec2 uv{0};
    SurfaceDerivatives s;
};

Place random_place(const SurfaceModel& model, test::Random& random) {
    Place place;
    place.patch = static_cast<std::uint32_t>(test::pick(random, model.patches.size()));
    place.uv = Vec2(test::uniform(random, 0, 1), test::uniform(random, 0, 1));
    place.s = evaluate(model.patch(place.patch), place.uv, 2);
    return place;
}

std::optional<PrincipalCurvatures> curvatures_at(const Place& place) {
    const Vec3 n = place.s.du().cross(place.s.dv());
    // Beside a pole either program has lost the digits that are compared.
    constexpr double beside_a_pole = 1e-2;
    const double u = place.s.du().length(), v = place.s.dv().length();
    if (!(std::min(u, v) > beside_a_pole * std::max(u, v) && n.length() > beside_a_pole * u * v))
        return std::nullopt;
    return principal_curvatures(place.s, n.normalized());
}

/// The faces of a file as OpenCASCADE has them, found by a place that lies on them.
class Peer {
public:
    Peer(const std::filesystem::path& file, const SurfaceModel& model)
        : model_(model), match_(model.faces.size(), no_index) {
        const TopoDS_Shape shape = test::read_shape(file);
        for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next())
            surfaces_.emplace_back(TopoDS::Face(e.Current()), false);
    }

    /// At the same place of the same face, or nothing where none is there by the same parameters.
    std::optional<BRepLProp_SLProps> at(const Place& place, double tolerance) {
        const std::uint32_t face = model_.patches[place.patch].face;
        if (match_[face] != no_index) return properties(match_[face], place, tolerance);
        for (std::uint32_t i = 0; i < surfaces_.size(); ++i)
            if (const auto found = properties(i, place, tolerance)) {
                match_[face] = i;
                return found;
            }
        return std::nullopt;
    }

private:
    std::optional<BRepLProp_SLProps> properties(std::uint32_t surface, const Place& place,
                                                double tolerance) const {
        const Vec2 uv = model_.face_parameters(place.patch, place.uv);
        BRepLProp_SLProps found(surfaces_[surface], uv.x, uv.y, 2, 1e-12);
        const gp_Pnt& p = found.Value();
        if ((Vec3(p.X(), p.Y(), p.Z()) - place.s.position()).length() > tolerance)
            return std::nullopt;
        return found;
    }

    const SurfaceModel& model_;
    std::vector<BRepAdaptor_Surface> surfaces_;
    std::vector<std::uint32_t> match_; ///< of each of Keiko's faces
};

void expect_same(const PrincipalCurvatures& ours, BRepLProp_SLProps& theirs, double size) {
    const double largest = std::max({std::abs(ours.k1), std::abs(ours.k2), 1 / size});
    EXPECT_NEAR(ours.mean(), theirs.MeanCurvature(), share * largest);
    EXPECT_NEAR(ours.gaussian(), theirs.GaussianCurvature(), 2 * share * largest * largest);
    // OpenCASCADE takes the root of H^2 - K, which loses digits where they are nearly equal:
    // rounding of some 1e-15 of H^2 becomes that over the difference.
    const double half = (ours.k1 - ours.k2) / 2;
    const double lost = 1e-13 * largest * largest / std::max(half, 1e-7 * largest);
    EXPECT_NEAR(ours.k1, theirs.MaxCurvature(), share * largest + lost);
    EXPECT_NEAR(ours.k2, theirs.MinCurvature(), share * largest + lost);
}

void expect_agreement(const std::filesystem::path& file) {
    const SurfaceModel model = load_model(file);
    const double size = hull_bounds(model).size();
    Peer peer(file, model);
    test::Random random(20261121);
    int compared = 0, regular = 0;
    for (int i = 0; i < place_count; ++i) {
        const Place place = random_place(model, random);
        const auto ours = curvatures_at(place);
        if (!ours) continue;
        ++regular;
        auto theirs = peer.at(place, share * size);
        if (!theirs || !theirs->IsCurvatureDefined()) continue;
        ++compared;
        expect_same(*ours, *theirs, size);
        if (testing::Test::HasFailure()) {
            ADD_FAILURE() << "patch " << place.patch << " at " << place.uv.x << ", " << place.uv.y;
            return;
        }
    }
    EXPECT_GT(regular, place_count * 9 / 10);
    EXPECT_GT(compared, regular * 99 / 100);
}

class OpenCascadeCurvature : public testing::TestWithParam<const char*> {};

TEST_P(OpenCascadeCurvature, IsTheSameAtRandomPlacesOfRealPanels) {
    KEIKO_NEEDS_SHARED_MODEL(GetParam());
    expect_agreement(test::shared_model(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(RealModels, OpenCascadeCurvature,
                         testing::Values("car-front-fender.brep", "car-hood.brep",
                                         "car-rear-deck-half-panel.brep"),
                         test::file_test_name);

class OpenCascadeFixtureCurvature : public testing::TestWithParam<const char*> {};

TEST_P(OpenCascadeFixtureCurvature, IsTheSameAtRandomPlaces) {
    expect_agreement(test::repository("surfaces") / GetParam());
}

INSTANTIATE_TEST_SUITE_P(Surfaces, OpenCascadeFixtureCurvature,
                         testing::Values("bored-block.step", "hood.step", "concept-car.step",
                                         "rational-sphere.step", "dent.step"),
                         test::file_test_name);

/// A surface of revolution about z: r and z along its profile, one rational patch a quarter.
SurfaceModel revolved(int degree, const std::vector<double>& knots,
                      const std::vector<Vec4>& profile) {
    test::ModelBuilder builder;
    builder.nurbs(test::revolution(degree, knots, profile));
    return builder.build();
}

/// `exact` tells the principal curvatures at a place, of either sign.
template <class Exact>
void expect_closed_form(const SurfaceModel& model, const Exact& exact) {
    const double size = hull_bounds(model).size();
    test::Random random(5);
    for (int i = 0; i < place_count; ++i) {
        const Place place = random_place(model, random);
        const auto ours = curvatures_at(place);
        if (!ours) continue;
        const PrincipalCurvatures k = exact(place.s.position());
        const double unit = share * std::max({std::abs(k.k1), std::abs(k.k2), 1 / size});
        const bool turned = std::abs(ours->k1 - k.k1) > unit || std::abs(ours->k2 - k.k2) > unit;
        ASSERT_NEAR(turned ? -ours->k2 : ours->k1, k.k1, unit);
        ASSERT_NEAR(turned ? -ours->k1 : ours->k2, k.k2, unit);
    }
}

TEST(PrincipalCurvatures, AreThoseOfASphere) {
    expect_closed_form(test::sphere_model({}), [](const Vec3&) {
        return PrincipalCurvatures{1, 1};
    });
}

TEST(PrincipalCurvatures, AreThoseOfACylinder) {
    for (const double radius : {0.5, 80.0, 2500.0})
        expect_closed_form(
            revolved(1, {0, 0, 1, 1}, {Vec4(radius, 0, 0, 1), Vec4(radius, 0, 100, 1)}),
            [&](const Vec3&) {
                return PrincipalCurvatures{1 / radius, 0};
            });
}

TEST(PrincipalCurvatures, AreThoseOfACone) {
    // 1 / k is the length of the normal down to the axis.
    const double top = 40, bottom = 90;
    expect_closed_form(revolved(1, {0, 0, 1, 1}, {Vec4(bottom, 0, 0, 1), Vec4(top, 0, 100, 1)}),
                       [&](const Vec3& p) {
                           const double slant = std::hypot(1.0, (bottom - top) / 100);
                           return PrincipalCurvatures{1 / (std::hypot(p.x, p.y) * slant), 0};
                       });
}

TEST(PrincipalCurvatures, AreThoseOfATorus) {
    const double s = std::numbers::sqrt2 / 2, ring = 100, tube = 30;
    std::vector<Vec4> profile;
    const Vec3 circle[9] = {{1, 0, 1},   {s, s, s},  {0, 1, 1},  {-s, s, s}, {-1, 0, 1},
                            {-s, -s, s}, {0, -1, 1}, {s, -s, s}, {1, 0, 1}};
    for (const Vec3& c : circle) profile.emplace_back(ring * c.z + tube * c.x, 0, tube * c.y, c.z);
    expect_closed_form(revolved(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, profile),
                       [&](const Vec3& p) {
                           const double r = std::hypot(p.x, p.y);
                           return PrincipalCurvatures{1 / tube, (r - ring) / (tube * r)};
                       });
}

} // namespace
} // namespace keiko
