#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/import/worker/load_model.h"

#include "tests/support/temporary_folder.h"
#include "tests/unit/import/converted_shape.h"
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko::cad {
namespace {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, TopAbs_FACE, map);
    std::vector<TopoDS_Face> faces;
    for (int i = 1; i <= map.Extent(); ++i) faces.push_back(TopoDS::Face(map(i)));
    return faces;
}

/// Patches on the surface, p-curves on the borders, area and edges of a shape.
void expect_faithful(const TopoDS_Shape& shape) {
    const SurfaceModel model = converted(shape);
    const auto faces = faces_of(shape);
    ASSERT_EQ(model.faces.size(), faces.size());
    EXPECT_TRUE(model.lost_faces.empty());
    EXPECT_TRUE(model.diagnostics.empty()) << model.diagnostics.front().message;
    EXPECT_TRUE(model.repairs.empty()) << text_of(model.repairs.front().kind);
    const double size = material_bounds(model).size();
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Face& face = model.faces[f];
        const BRepAdaptor_Surface surface(faces[f], false);
        for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p)
            for (int i = 0; i <= 8; ++i)
                for (int j = 0; j <= 8; ++j) {
                    const Vec2 uv(i / 8.0, j / 8.0), at = model.face_parameters(p, uv);
                    const gp_Pnt wanted = surface.Value(at.x, at.y);
                    const Vec3 got = evaluate(model.patch(p), uv, 0).position();
                    EXPECT_LT((got - Vec3(wanted.X(), wanted.Y(), wanted.Z())).length(),
                              1e-12 * size);
                }
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(faces[f], properties);
        EXPECT_NEAR(area(model, face) / properties.Mass(), 1, 5e-3) << face.surface_kind;
        EXPECT_EQ(face.reversed, faces[f].Orientation() == TopAbs_REVERSED);
    }
    for (const Edge& edge : model.edges) EXPECT_TRUE(edge.use_count == 2 || edge.degenerate);
}

/// mm of borders that meet no other; negative where seams claim some of them twice.
double free_length(const SurfaceModel& model) {
    const BoundaryCurves curves(model);
    const auto length = [&](const BoundaryInterval& i) {
        return curves.curve(i).length(std::min(i.begin, i.end), std::max(i.begin, i.end));
    };
    double free = 0;
    for (const BoundaryInterval& border : curves.all()) free += length(border);
    for (const Seam& seam : pair_seams(model, 0.5)) free -= length(seam.a) + length(seam.b);
    return free;
}

/// Also those smaller than the join distance, and in NURBS, whose borders begin elsewhere.
TEST(CadPrimitives, ClosedSolidsHaveNoFreeBorder) {
    const gp_Ax2 aslant(gp_Pnt(10, 5, 3), gp_Dir(1, 2, 3));
    const TopoDS_Shape solids[] = {BRepPrimAPI_MakeTorus(60, 20),
                                   BRepPrimAPI_MakeTorus(aslant, 10, 3),
                                   BRepPrimAPI_MakeTorus(60, 20, 1.5),
                                   BRepPrimAPI_MakeTorus(60, 20, -0.5, 1.2),
                                   BRepPrimAPI_MakeSphere(aslant, 50),
                                   BRepPrimAPI_MakeSphere(50, -0.5, 1, 2),
                                   BRepPrimAPI_MakeCylinder(aslant, 40, 90),
                                   BRepPrimAPI_MakeCone(50, 20, 80),
                                   BRepPrimAPI_MakeCone(50, 0, 80),
                                   BRepPrimAPI_MakeBox(10, 20, 30)};
    for (const double scale : {1e-3, 1.0, 1e3})
        for (std::size_t i = 0; i < std::size(solids); ++i) {
            gp_Trsf scaled;
            scaled.SetScale(gp_Pnt(0, 0, 0), scale);
            const TopoDS_Shape shape = BRepBuilderAPI_Transform(solids[i], scaled, true);
            const TopoDS_Shape nurbs = BRepBuilderAPI_NurbsConvert(shape, true);
            EXPECT_NEAR(free_length(converted(shape)), 0, 1e-6 * scale) << i << " by " << scale;
            EXPECT_NEAR(free_length(converted(nurbs)), 0, 1e-6 * scale) << i << " by " << scale;
        }
}

// The top of a large sphere, with its pole at the origin: of the border there only rounding is
// left, which is that of the radius.
TEST(CadPrimitives, PolesAtTheOriginHaveNoLength) {
    constexpr double angle = 0.0014, radius = 50 / angle, quarter = std::numbers::pi / 2;
    const gp_Ax2 below(gp_Pnt(0, 0, -radius), gp::DZ());
    const TopoDS_Shape solid = BRepPrimAPI_MakeSphere(below, radius, quarter - angle, quarter);
    const SurfaceModel model = converted(faces_of(solid)[0]);
    const BoundaryCurves curves(model);
    double sum = 0;
    for (const BoundaryInterval& border : curves.all()) sum += curves.curve(border).length(0, 1);
    const double rim = 2 * std::numbers::pi * radius * std::sin(angle), side = radius * angle;
    EXPECT_NEAR(sum, rim + 2 * side, 1e-6);
}

TEST(CadPrimitives, SolidsAreConvertedFaithfully) {
    expect_faithful(BRepPrimAPI_MakeBox(gp_Pnt(1, 2, 3), 10, 20, 30).Shape());
    expect_faithful(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 5, 5), gp_Dir(1, 1, 1)), 4, 9));
    expect_faithful(BRepPrimAPI_MakeCone(5, 2, 8).Shape());
    expect_faithful(BRepPrimAPI_MakeCone(5, 0, 8).Shape());
    expect_faithful(BRepPrimAPI_MakeSphere(6).Shape());
    expect_faithful(BRepPrimAPI_MakeSphere(6, -0.5, 1.0, 2.0).Shape());
    expect_faithful(BRepPrimAPI_MakeTorus(10, 3).Shape());
    expect_faithful(BRepPrimAPI_MakeTorus(10, 3, 4.0).Shape());
}

TEST(CadPrimitives, SweptSolidsAreConvertedFaithfully) {
    const TopoDS_Edge circle =
        BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(20, 0, 0), gp_Dir(0, 1, 0)), 5));
    const TopoDS_Face disc = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(circle).Wire());
    expect_faithful(BRepPrimAPI_MakePrism(disc, gp_Vec(3, 15, 4)));
    expect_faithful(BRepPrimAPI_MakeRevol(disc, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 2.5));
}

TEST(CadPrimitives, HolesAreCutOut) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(40, 30, 5).Shape();
    const TopoDS_Shape drill =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(15, 12, -1), gp_Dir(0.1, 0, 1)), 6, 10);
    expect_faithful(BRepAlgoAPI_Cut(plate, drill).Shape());
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 20).Shape();
    const TopoDS_Shape across =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0.05, 0.1)), 6, 30);
    expect_faithful(BRepAlgoAPI_Cut(ball, across).Shape());
}

TEST(CadPrimitives, TheSeamIsOneEdgeUsedTwice) {
    const SurfaceModel model = converted(BRepPrimAPI_MakeCylinder(4, 9).Shape());
    ASSERT_EQ(model.edges.size(), 3u);
    for (const Edge& edge : model.edges) EXPECT_EQ(edge.use_count, 2u);
}

TEST(CadPrimitives, FaceLocationsMoveThePatches) {
    gp_Trsf move;
    move.SetMirror(gp_Ax2(gp_Pnt(7, 0, 0), gp_Dir(1, 0, 0)));
    const TopoDS_Shape moved =
        BRepPrimAPI_MakeTorus(10, 3).Shape().Moved(TopLoc_Location(move), false);
    const SurfaceModel model = converted(moved);
    const BRepAdaptor_Surface surface(faces_of(moved)[0]);
    const Vec2 at = model.face_parameters(0, {0.4, 0.7});
    const gp_Pnt wanted = surface.Value(at.x, at.y);
    const Vec3 got = evaluate(model.patch(0), {0.4, 0.7}, 0).position();
    EXPECT_LT((got - Vec3(wanted.X(), wanted.Y(), wanted.Z())).length(), 1e-12);
}

TEST(CadPrimitives, AnInfinitePlaneIsLostWithItsReason) {
    const SurfaceModel model = converted(BRepBuilderAPI_MakeFace(gp_Pln()).Face());
    ASSERT_EQ(model.lost_faces.size(), 1u);
    EXPECT_EQ(model.lost_faces[0].reason, "an infinite plane without bounds");
}

TEST(CadFiles, AStepFileComesBackThroughTheWorkerAndFailsWhenCut) {
    const test::TemporaryFolder folder;
    const auto path = folder.path() / "box.step";
    STEPControl_Writer writer;
    writer.Transfer(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), STEPControl_AsIs);
    ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    const SurfaceModel model = load_model(path);
    EXPECT_EQ(model.faces.size(), 6u);
    EXPECT_EQ(model.format, "STEP");
    EXPECT_LT((material_bounds(model).upper - Vec3(10, 20, 30)).length(), 1e-9);
    const std::string whole = read_file(path);
    for (const std::size_t share : {10, 50, 90})
        EXPECT_THROW(
            load_model(folder.file("cut.step", whole.substr(0, whole.size() * share / 100))),
            Error);
}

TEST(CadFiles, ABrepFileOfWiresHasNoFaces) {
    const test::TemporaryFolder folder;
    const auto path = folder.path() / "edge.brep";
    BRepTools::Write(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1)).Edge(),
                     path.c_str());
    try {
        load_model(path);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.reason(), "no faces in the file");
    }
}

TEST(CadFiles, TooLittleMemoryIsOneLine) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer reserves more than any limit";
#endif
    const test::TemporaryFolder folder;
    const auto path = folder.path() / "boxes.brep";
    TopoDS_Compound many;
    BRep_Builder builder;
    builder.MakeCompound(many);
    for (int i = 0; i < 500; ++i) builder.Add(many, BRepPrimAPI_MakeBox(1, 2, 3 + i).Shape());
    BRepTools::Write(many, path.c_str());
    LoadOptions options;
    options.memory_limit = 1 << 20;
    EXPECT_THROW(load_model(path, options), Error);
}

} // namespace
} // namespace keiko::cad
