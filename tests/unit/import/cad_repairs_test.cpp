#include "keiko/files/model/model_serialization.h"

#include "tests/unit/import/converted_shape.h"
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko::cad {
namespace {

constexpr double pi = std::numbers::pi;
using Surface = opencascade::handle<Geom_Surface>;

using Segment = std::pair<Vec2, Vec2>;

/// From corner to corner and back to the first.
std::vector<Segment> ring(const std::vector<Vec2>& corners) {
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < corners.size(); ++i)
        segments.push_back({corners[i], corners[(i + 1) % corners.size()]});
    return segments;
}

/// Makes faces with faults that OpenCASCADE's own functions would not make.
class FaceMaker {
public:
    explicit FaceMaker(const Surface& surface) : surface_(surface) {
        builder_.MakeFace(face_, surface, 1e-7);
    }

    /// Adds a wire of straight p-curves. On a plane edges get their curves in space as well.
    FaceMaker& wire(const std::vector<Segment>& segments, double tolerance = 1e-7) {
        TopoDS_Wire wire;
        builder_.MakeWire(wire);
        for (const auto& [a, b] : segments) {
            TopoDS_Edge edge;
            if (surface_->IsKind(STANDARD_TYPE(Geom_Plane)))
                edge = BRepBuilderAPI_MakeEdge(gp_Pnt(a.x, a.y, 0), gp_Pnt(b.x, b.y, 0));
            else
                builder_.MakeEdge(edge);
            const Vec2 way = b - a;
            const opencascade::handle<Geom2d_Line> line =
                new Geom2d_Line(gp_Pnt2d(a.x, a.y), gp_Dir2d(way.x, way.y));
            builder_.UpdateEdge(edge, line, face_, tolerance);
            builder_.Range(edge, face_, 0, way.length());
            builder_.Add(wire, edge);
        }
        return this->wire(wire);
    }
    FaceMaker& wire(const TopoDS_Wire& wire) {
        builder_.Add(face_, wire);
        return *this;
    }

    const TopoDS_Face& face() const { return face_; }
    BRep_Builder& builder() { return builder_; }

private:
    BRep_Builder builder_;
    Surface surface_;
    TopoDS_Face face_;
};

Surface plane() {
    return new Geom_Plane(gp_Ax3());
}

/// The one repair of a kind, or null.
const Repair* repair(const SurfaceModel& model, RepairKind kind) {
    const auto found = std::find_if(model.repairs.begin(), model.repairs.end(),
                                    [&](const Repair& r) { return r.kind == kind; });
    return found == model.repairs.end() ? nullptr : &*found;
}

/// The shape must become one whole face of that area, with a repair of that kind and no other.
Repair expect_repaired(const TopoDS_Shape& shape, double wanted_area, RepairKind kind,
                       double accuracy = 5e-3) {
    const SurfaceModel model = converted(shape);
    EXPECT_TRUE(model.lost_faces.empty()) << model.lost_faces[0].reason;
    if (model.faces.size() != 1) return {};
    EXPECT_NEAR(area(model, model.faces[0]) / wanted_area, 1, accuracy);
    EXPECT_EQ(model.repairs.size(), 1u);
    const Repair* found = repair(model, kind);
    EXPECT_NE(found, nullptr);
    if (!found) return {};
    EXPECT_EQ(found->face, 1u);
    return *found;
}

void expect_whole(const TopoDS_Shape& shape, double wanted_area) {
    const SurfaceModel model = converted(shape);
    ASSERT_EQ(model.faces.size(), 1u);
    EXPECT_TRUE(model.repairs.empty()) << text_of(model.repairs[0].kind);
    EXPECT_NEAR(area(model, model.faces[0]) / wanted_area, 1, 5e-3);
}

TEST(CadRepairs, AGapBetweenEdgesIsBridgedAndMeasured) {
    const Repair gap = expect_repaired(
        FaceMaker(plane())
            .wire({{{0, 0}, {10, 0}}, {{10, 0.01}, {10, 5}}, {{10, 5}, {0, 5}}, {{0, 5}, {0, 0}}})
            .face(),
        50, RepairKind::gap_bridged);
    EXPECT_NEAR(gap.size, 0.01, 1e-12);
}

TEST(CadRepairs, AnEdgeThatRunsAgainstItsWireIsReversed) {
    expect_repaired(
        FaceMaker(plane())
            .wire({{{0, 0}, {10, 0}}, {{10, 5}, {10, 0}}, {{10, 5}, {0, 5}}, {{0, 5}, {0, 0}}})
            .face(),
        50, RepairKind::edge_reversed);
}

TEST(CadRepairs, AnOpenLoopIsClosedAndMeasured) {
    const Repair closed = expect_repaired(
        FaceMaker(plane())
            .wire({{{0, 0}, {10, 0}}, {{10, 0}, {10, 5}}, {{10, 5}, {0, 5}}, {{0, 5}, {0, 0.02}}})
            .face(),
        50, RepairKind::loop_closed);
    EXPECT_NEAR(closed.size, 0.02, 1e-12);
}

TEST(CadRepairs, MissingPCurvesAreBuilt) {
    FaceMaker maker(new Geom_CylindricalSurface(gp_Ax3(), 5));
    const auto arc = [](double height, double begin, double end) {
        return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, height), gp_Dir(0, 0, 1)), 5),
                                       begin, end)
            .Edge();
    };
    const auto upright = [](double angle) {
        const double x = 5 * std::cos(angle), y = 5 * std::sin(angle);
        return BRepBuilderAPI_MakeEdge(gp_Pnt(x, y, 0), gp_Pnt(x, y, 4)).Edge();
    };
    TopoDS_Wire wire;
    maker.builder().MakeWire(wire);
    maker.builder().Add(wire, arc(0, 1, 3));
    maker.builder().Add(wire, upright(3));
    maker.builder().Add(wire, arc(4, 1, 3).Reversed());
    maker.builder().Add(wire, upright(1).Reversed());
    const Repair built =
        expect_repaired(maker.wire(wire).face(), 5 * 2 * 4, RepairKind::p_curve_built);
    EXPECT_EQ(built.count, 4u);
    EXPECT_LT(built.size, 1e-7);
}

/// A square of 10 mm whose first edge lies 2 mm above its plane, in two places.
TEST(CadRepairs, AnEdgeOffItsSurfaceIsToldAndItsCurveOnTheSurfaceCounts) {
    FaceMaker maker(plane());
    const gp_Pnt corners[] = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
    TopoDS_Wire wire;
    maker.builder().MakeWire(wire);
    for (int i = 0; i < 4; ++i) {
        const gp_Vec up(0, 0, i == 0 ? 2 : 0);
        const TopoDS_Edge edge =
            BRepBuilderAPI_MakeEdge(corners[i].Translated(up), corners[(i + 1) % 4].Translated(up));
        if (i == 0) maker.builder().UpdateEdge(edge, 2.1);
        maker.builder().Add(wire, edge);
    }
    maker.wire(wire);
    gp_Trsf move;
    move.SetTranslation(gp_Vec(30, 0, 50));
    for (const TopLoc_Location& place : {TopLoc_Location(), TopLoc_Location(move)}) {
        const Repair off =
            expect_repaired(maker.face().Moved(place), 100, RepairKind::p_curve_built);
        EXPECT_NEAR(off.size, 2, 1e-9);
    }
}

TEST(CadRepairs, AHoleThatRunsLikeItsOutlineIsStillAHole) {
    const auto outline = ring({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const auto hole = ring({{2, 2}, {5, 2}, {5, 5}, {2, 5}});
    expect_repaired(FaceMaker(plane()).wire(outline).wire(hole).face(), 91,
                    RepairKind::loop_runs_backwards);
}

TEST(CadRepairs, ATinyEdgeIsKeptAndTold) {
    const Repair tiny = expect_repaired(
        FaceMaker(plane()).wire(ring({{0, 0}, {10, 0}, {10, 1e-4}, {10, 5}, {0, 5}}), 1e-3).face(),
        50, RepairKind::tiny_edge);
    EXPECT_NEAR(tiny.size, 1e-4, 1e-12);
}

TEST(CadRepairs, ALoopThatTouchesItselfNeedsNone) {
    expect_whole(
        FaceMaker(plane()).wire(ring({{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}})).face(), 8);
}

/// The mantle of a cylinder, whose wire holds its seam twice; the wire begins with its edge
/// `first`.
TopoDS_Face mantle(std::size_t first) {
    static const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 20).Shape();
    const TopoDS_Face face = TopoDS::Face(TopExp_Explorer(cylinder, TopAbs_FACE).Current());
    std::vector<TopoDS_Shape> edges;
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) edges.push_back(e.Current());
    std::rotate(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(first), edges.end());
    BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const TopoDS_Shape& edge : edges) builder.Add(wire, edge);
    wire.Closed(true);
    TopoDS_Face turned = TopoDS::Face(face.EmptyCopied());
    builder.Add(turned, wire);
    return turned;
}

TEST(CadRepairs, AWireThatHoldsAnEdgeTwiceBeginsAtOnePlaceWhateverTheOrder) {
    const std::string one = serialize(converted(mantle(0)));
    for (const std::size_t first : {1u, 2u, 3u})
        EXPECT_EQ(serialize(converted(mantle(first))), one) << first;
}

TEST(CadRepairs, AnEdgeInsideTheFaceIsLeftOut) {
    FaceMaker maker(plane());
    maker.wire(ring({{0, 0}, {10, 0}, {10, 5}, {0, 5}}));
    TopoDS_Wire wire;
    maker.builder().MakeWire(wire);
    maker.builder().Add(
        wire,
        BRepBuilderAPI_MakeEdge(gp_Pnt(2, 2, 0), gp_Pnt(8, 3, 0)).Edge().Oriented(TopAbs_INTERNAL));
    expect_repaired(maker.wire(wire).face(), 50, RepairKind::edge_dropped);
}

TEST(CadRepairs, ASphereWithoutItsPolesGetsThem) {
    FaceMaker maker(new Geom_SphericalSurface(gp_Ax3(), 6));
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(6).Shape();
    TopoDS_Wire wire;
    maker.builder().MakeWire(wire);
    for (TopExp_Explorer e(sphere, TopAbs_EDGE); e.More(); e.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
        if (BRep_Tool::Degenerated(edge)) continue;
        const auto side = [](double u) {
            return opencascade::handle<Geom2d_Line>(
                new Geom2d_Line(gp_Pnt2d(u, -2 * pi), gp_Dir2d(0, 1))); // as the sphere has it
        };
        maker.builder().UpdateEdge(edge, side(2 * pi), side(0), maker.face(), 1e-7);
        maker.builder().Add(wire, edge);
    }
    const Repair poles =
        expect_repaired(maker.wire(wire).face(), 4 * pi * 36, RepairKind::degenerate_edge_added);
    EXPECT_EQ(poles.count, 2u);
}

TEST(CadRepairs, ClosedSurfacesWithoutWiresAreWhole) {
    expect_whole(FaceMaker(new Geom_SphericalSurface(gp_Ax3(), 6)).face(), 4 * pi * 36);
    expect_whole(FaceMaker(new Geom_ToroidalSurface(gp_Ax3(), 10, 3)).face(), 4 * pi * pi * 30);
}

TEST(CadRepairs, ACylinderALittleBeyondAFullTurnIsWhole) {
    const double turn = 2 * pi + 4e-13;
    expect_whole(FaceMaker(new Geom_CylindricalSurface(gp_Ax3(), 5))
                     .wire(ring({{0, 0}, {turn, 0}, {turn, 4}, {0, 4}}))
                     .face(),
                 2 * pi * 5 * 4);
}

TEST(CadRepairs, WiresAroundACylinderWithoutASeamAreClosed) {
    const Repair closed = expect_repaired(FaceMaker(new Geom_CylindricalSurface(gp_Ax3(), 5))
                                              .wire({{{0, 0}, {2 * pi, 0}}})
                                              .wire({{{2 * pi, 4}, {0, 4}}})
                                              .face(),
                                          2 * pi * 5 * 4, RepairKind::wire_around_closed);
    EXPECT_EQ(closed.count, 2u);
}

TEST(CadRepairs, AnOffsetSurfaceIsApproximatedAndMarked) {
    TColgp_Array2OfPnt poles(1, 3, 1, 2);
    for (int i = 1; i <= 3; ++i)
        for (int j = 1; j <= 2; ++j) poles(i, j) = gp_Pnt(10 * i, i == 2 ? 8 : 0, 20 * j);
    const Surface curved = new Geom_BezierSurface(poles);
    const SurfaceModel model = converted(FaceMaker(new Geom_OffsetSurface(curved, 2)).face());
    ASSERT_EQ(model.faces.size(), 1u);
    const Repair* marked = repair(model, RepairKind::surface_approximated);
    ASSERT_NE(marked, nullptr);
    EXPECT_EQ(marked->size, model.faces[0].approximated);
    EXPECT_LE(marked->size, 1e-4);
    EXPECT_GT(marked->size, 0);
}

} // namespace
} // namespace keiko::cad
