#include "keiko/files/model/model_format.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/trim/material_bounds.h"

#include "tests/support/paths.h"
#include "tests/unit/import/converted_shape.h"
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Bnd_Box.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko::cad {
namespace {

void expect_box(const Box3& found, const Box3& expected, double tolerance) {
    for (unsigned k = 0; k < 3; ++k) {
        EXPECT_NEAR(found.lower[k], expected.lower[k], tolerance) << "lower, axis " << k;
        EXPECT_NEAR(found.upper[k], expected.upper[k], tolerance) << "upper, axis " << k;
    }
}

/// OpenCASCADE's own box of all placed shapes.
Box3 peer_box(const CadDocument& document) {
    Bnd_Box box;
    for (const CadInstance& instance : document.instances) {
        const TopoDS_Shape& shape = document.parts[instance.part].shape;
        gp_Trsf placed;
        const auto& r = instance.transform.rows;
        const Vec3& t = instance.transform.translation;
        placed.SetValues(r[0].x, r[0].y, r[0].z, t.x, r[1].x, r[1].y, r[1].z, t.y, r[2].x, r[2].y,
                         r[2].z, t.z);
        BRepBndLib::AddOptimal(BRepBuilderAPI_Transform(shape, placed).Shape(), box, false, false);
    }
    Box3 result;
    box.SetGap(0);
    box.Get(result.lower.x, result.lower.y, result.lower.z, result.upper.x, result.upper.y,
            result.upper.z);
    return result;
}

gp_Trsf turned(const gp_Dir& axis, double angle) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), axis), angle);
    return turn;
}

TEST(CadBounds, OfABallCutByAPlaneEndAtTheCut) {
    // The ball of radius 10 as far as z <= 6, and its poles turned into the x axis.
    for (const double angle : {0.0, 0.6, std::numbers::pi / 2}) {
        const TopoDS_Shape ball = BRepBuilderAPI_Transform(BRepPrimAPI_MakeSphere(10).Shape(),
                                                           turned(gp_Dir(0, 1, 0), angle));
        const TopoDS_Shape half =
            BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -20), gp_Pnt(20, 20, 6)).Shape();
        const Box3 expected{{-10, -10, -10}, {10, 10, 6}};
        expect_box(material_bounds(converted(BRepAlgoAPI_Common(ball, half).Shape())), expected,
                   1e-6);
    }
}

TEST(CadBounds, OfABallCutByATiltedPlaneFollowTheRim) {
    // The cap of the ball beyond a plane at distance d with normal n. A direction e has its highest
    // place on the ball where e points into the cap, else on the rim.
    const double radius = 10, d = 6, tilt = 0.5;
    const TopoDS_Shape half =
        BRepBuilderAPI_Transform(
            BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, d), gp_Pnt(20, 20, 40)).Shape(),
            turned(gp_Dir(0, 1, 0), tilt))
            .Shape();
    const SurfaceModel model =
        converted(BRepAlgoAPI_Common(BRepPrimAPI_MakeSphere(radius).Shape(), half).Shape());
    const Vec3 n(std::sin(tilt), 0, std::cos(tilt));
    const auto reach = [&](const Vec3& e) {
        const double along = e.dot(n);
        if (radius * along >= d) return radius;
        return d * along + std::sqrt((radius * radius - d * d) * (1 - along * along));
    };
    Box3 expected;
    for (unsigned k = 0; k < 3; ++k) {
        Vec3 e(0);
        e[k] = 1;
        expected.upper[k] = reach(e);
        expected.lower[k] = -reach(-e);
    }
    expect_box(material_bounds(model), expected, 1e-6);
}

TEST(CadBounds, OfABoredTurnedBlockAreThoseOfItsCorners) {
    const TopoDS_Shape bored =
        BRepAlgoAPI_Cut(
            BRepPrimAPI_MakeBox(40, 30, 20).Shape(),
            BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 15, -5), gp_Dir(0, 0, 1)), 8, 30).Shape())
            .Shape();
    const gp_Trsf turn = turned(gp_Dir(1, 2, 3), 0.4);
    Box3 expected;
    for (int i = 0; i < 8; ++i) {
        const gp_Pnt corner =
            gp_Pnt(i & 1 ? 40 : 0, i & 2 ? 30 : 0, i & 4 ? 20 : 0).Transformed(turn);
        expected.extend(Vec3(corner.X(), corner.Y(), corner.Z()));
    }
    expect_box(material_bounds(converted(BRepBuilderAPI_Transform(bored, turn).Shape())), expected,
               1e-9);
}

TEST(CadBounds, OfTheWallOfATiltedCutDoNotReachWhereTheCylinderWas) {
    // A cylinder of radius 5 about z, from z = 0 to the plane z = 20 + x / 2.
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(5, 60).Shape();
    gp_Trsf turn = turned(gp_Dir(0, 1, 0), -std::atan(0.5)), rise;
    rise.SetTranslation(gp_Vec(0, 0, 20));
    const TopoDS_Shape above =
        BRepBuilderAPI_Transform(
            BRepPrimAPI_MakeBox(gp_Pnt(-90, -90, 0), gp_Pnt(90, 90, 90)).Shape(), rise * turn)
            .Shape();
    const SurfaceModel model = converted(BRepAlgoAPI_Cut(cylinder, above).Shape());
    expect_box(material_bounds(model), {{-5, -5, 0}, {5, 5, 22.5}}, 1e-6);
}

constexpr const char* peer_models[] = {"box-with-nurbs-sphere.step",
                                       "bspline-sphere-degree-10.brep",
                                       "car-front-fender.brep",
                                       "car-hood.brep",
                                       "car-rear-deck-half-panel.brep",
                                       "patch-pair-192.brep",
                                       "pump-carter.step",
                                       "shoe-c0-bspline.brep",
                                       "submarine-in-far-field.step",
                                       "torus.brep"};

/// A second implementation, which samples and then polishes. It grows each side by 1e-7 mm.
TEST(CadBounds, AreThoseOfOpenCascadeOnSharedModels) {
    KEIKO_NEEDS_SHARED_MODEL("MANIFEST.tsv");
    for (const char* name : peer_models) {
        SCOPED_TRACE(name);
        const auto path = test::shared_model(name);
        const CadDocument document = read_document(path, detect_model_format(path));
        const Box3 found = material_bounds(convert_document(document));
        expect_box(found, peer_box(document), 1e-8 * found.size() + 2e-7);
    }
}

/// Material at the nodes of a grid over each patch, and places of the trim curves.
Box3 sampled(const SurfaceModel& model, int cells, int steps) {
    Box3 box;
    for (const Face& face : model.faces) {
        const TrimRegion material(model, face);
        for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p)
            for (int i = 0; i <= cells; ++i)
                for (int j = 0; j <= cells; ++j) {
                    const Vec2 uv(double(i) / cells, double(j) / cells);
                    const Vec3 place = evaluate(model.patch(p), uv, 0).position();
                    if (!box.contains(place) && material.contains(model.face_parameters(p, uv)))
                        box.extend(place);
                }
    }
    const BoundaryCurves borders(model);
    for (const BoundaryInterval& border : borders.all())
        for (int k = 0; k <= steps; ++k)
            box.extend(borders.curve(border).at(double(k) / steps).position);
    return box;
}

TEST(CadBounds, HoldDenseSamplesOfSharedModelsAndNotMuchMore) {
    KEIKO_NEEDS_SHARED_MODEL("MANIFEST.tsv");
    for (const char* name : {"car-hood.brep", "car-rear-deck-half-panel.brep",
                             "patch-pair-104.brep", "ship-dtmb5415-bulbous-bow.igs"}) {
        SCOPED_TRACE(name);
        const auto path = test::shared_model(name);
        const SurfaceModel model = convert_document(read_document(path, detect_model_format(path)));
        const Box3 found = material_bounds(model), samples = sampled(model, 50, 400);
        EXPECT_TRUE(found.padded(1e-12 * found.size()).contains(samples.lower));
        EXPECT_TRUE(found.padded(1e-12 * found.size()).contains(samples.upper));
        // Between two samples the material rises by no more than this share of its size.
        expect_box(found, samples, 3e-6 * found.size());
    }
}

} // namespace
} // namespace keiko::cad
