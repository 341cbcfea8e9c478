#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/combs/comb_curves.h"

#include "tests/integration/opencascade_tracer.h"
#include "tests/support/file_test_name.h"
#include "tests/support/paths.h"
#include <BRepAlgoAPI_Section.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace keiko {
namespace {

using namespace test;

/// A section of a model, and how exactly OpenCASCADE's approximate one has its length.
struct SectionCase {
    const char* file;
    const char* plane;
    double length_error; ///< share
};

/// Curvature of the curve in which a plane cuts a surface by OpenCASCADE's derivatives: of the
/// zeros of n . S - d in the plane, with the place from OpenCASCADE's own projection.
struct PeerBend {
    double curvature = 0, rounding = 0; ///< 1/mm
};

std::optional<PeerBend> peer_bend(const Handle(Geom_Surface) & surface, const Vec3& place,
                                  const Vec3& plane) {
    GeomAPI_ProjectPointOnSurf projection(gp_Pnt(place.x, place.y, place.z), surface, 1e-12);
    if (projection.NbPoints() == 0 || projection.LowerDistance() > 1e-7) return {};
    double u = 0, v = 0;
    projection.LowerDistanceParameters(u, v);
    gp_Pnt p;
    gp_Vec su, sv, suu, svv, suv;
    surface->D2(u, v, p, su, sv, suu, svv, suv);
    const gp_Vec n(plane.x, plane.y, plane.z);
    const double a = n * sv, b = -(n * su); // along the curve
    const gp_Vec tangent = su * a + sv * b,
                 second = suu * (a * a) + suv * (2 * a * b) + svv * (b * b);
    // The tangent's own change lies in the surface: only what is normal to it tells.
    const gp_Vec normal = su.Crossed(sv).Normalized(), left = n.Crossed(tangent).Normalized();
    const double sine = left * normal;
    const double speed = tangent.SquareMagnitude();
    const double edge = std::min(su.Magnitude(), sv.Magnitude());
    constexpr double roundings = 1e3 * std::numeric_limits<double>::epsilon();
    return PeerBend{std::abs(second * normal / (speed * sine)),
                    roundings * place.length() * (suu.Magnitude() + svv.Magnitude()) /
                        (edge * edge * edge * sine * sine)};
}

class CombsAgainstOpenCascade : public testing::TestWithParam<SectionCase> {};

double peer_length(const TopoDS_Shape& shape, const SectionPlane& plane) {
    const gp_Dir normal(plane.normal.x, plane.normal.y, plane.normal.z);
    const Vec3 on = plane.normal * plane.height;
    BRepAlgoAPI_Section section(shape, gp_Pln(gp_Pnt(on.x, on.y, on.z), normal), false);
    section.Approximation(true);
    section.Build();
    GProp_GProps properties;
    BRepGProp::LinearProperties(section.Shape(), properties);
    return properties.Mass();
}

TEST_P(CombsAgainstOpenCascade, HaveTheSameCurvatureAndLength) {
    const SectionCase& given = GetParam();
    const bool own = std::filesystem::exists(repository("surfaces") / given.file);
    if (!own) KEIKO_NEEDS_SHARED_MODEL(given.file);
    const auto file = own ? repository("surfaces") / given.file : shared_model(given.file);
    const SurfaceModel model = load_model(file);
    const TopoDS_Shape shape = read_shape(file);
    std::vector<Handle(Geom_Surface)> surfaces;
    for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next())
        surfaces.push_back(BRep_Tool::Surface(TopoDS::Face(e.Current())));
    ASSERT_EQ(surfaces.size(), model.faces.size());
    CombOptions options;
    options.planes = {section_plane(given.plane)};
    const double size = hull_bounds(model).size();
    double length = 0, worst = 0;
    int compared = 0;
    for (const CombCurve& curve : comb_curves(model, options).curves) {
        length += curve.length;
        for (const CombPiece& piece : curve.pieces)
            for (std::size_t i = 1; i + 1 < piece.samples.size(); i += 7) {
                const CombSample& sample = piece.samples[i];
                const auto peer =
                    peer_bend(surfaces[piece.face], sample.place, options.planes[0].normal);
                if (!peer) continue;
                const double off =
                    std::abs(std::abs(sample.bend.curvature) - peer->curvature) - peer->rounding;
                worst = std::max(worst, off / std::max(peer->curvature, 1 / size));
                ++compared;
            }
    }
    std::cout << given.file << " " << given.plane << ": " << compared << " places, off by " << worst
              << " of the curvature or 1 / size; length " << length << ", OpenCASCADE "
              << peer_length(shape, options.planes[0]) << " mm\n";
    EXPECT_GT(compared, 10);
    EXPECT_LE(worst, 1e-9);
    EXPECT_NEAR(length / peer_length(shape, options.planes[0]), 1, given.length_error);
}

INSTANTIATE_TEST_SUITE_P(Sections, CombsAgainstOpenCascade,
                         testing::Values(SectionCase{"hood.step", "y=120", 1e-4},
                                         SectionCase{"hood.step", "1,0,1=900", 1e-4},
                                         SectionCase{"concept-car.step", "y=300", 1e-3},
                                         SectionCase{"torus.brep", "1,1,1=1", 1e-3},
                                         SectionCase{"car-hood.brep", "x=-300", 1e-3},
                                         SectionCase{"car-front-fender.brep", "z=700", 1e-3},
                                         SectionCase{"car-rear-deck-half-panel.brep", "y=300",
                                                     1e-3}),
                         [](const auto& given) { return "Case" + std::to_string(given.index); });

} // namespace
} // namespace keiko
