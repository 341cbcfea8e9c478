#include "keiko/import/cad/occt_face.h"

#include "keiko/math/polygon.h"

#include <BRep_Builder.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <array>
#include <vector>

namespace keiko::cad {
namespace {

/// A piece of a border: its homogeneous points in face parameters.
using BorderPiece = std::vector<Vec3>;
/// A closed border of a face, and its course as a polygon.
struct BorderLoop {
    std::vector<BorderPiece> pieces;
    std::vector<Vec2> polygon;

    explicit BorderLoop(std::vector<BorderPiece> all) : pieces(std::move(all)) {
        constexpr int samples = 8;
        for (const BorderPiece& piece : pieces)
            for (int i = 0; i < samples; ++i)
                polygon.push_back(evaluate({piece}, double(i) / samples, 0)[0]);
    }

    /// Twice the area that it runs around, positive counter-clockwise.
    double area() const {
        double sum = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i)
            sum += polygon[i].cross(polygon[(i + 1) % polygon.size()]);
        return sum;
    }
    /// Whether a point lies within.
    bool surrounds(const Vec2& p) const { return holds(polygon, p); }
};

/// The border of a rectangle, counter-clockwise.
BorderLoop rectangle(const Box2& box) {
    const std::array<Vec3, 4> corners{
        Vec3(box.lower.x, box.lower.y, 1), Vec3(box.upper.x, box.lower.y, 1),
        Vec3(box.upper.x, box.upper.y, 1), Vec3(box.lower.x, box.upper.y, 1)};
    std::vector<BorderPiece> pieces;
    for (std::size_t i = 0; i < 4; ++i) pieces.push_back({corners[i], corners[(i + 1) % 4]});
    return BorderLoop(std::move(pieces));
}

/// The loops of a face; of one without any the border of its parameters.
std::vector<BorderLoop> loops_of(const SurfaceModel& model, const Face& face, const Box2& domain) {
    std::vector<BorderLoop> loops;
    for (const TrimLoop& loop : model.loops_of(face)) {
        std::vector<BorderPiece> pieces;
        for (std::uint32_t i = 0; i < loop.curve_count; ++i) {
            const auto points = model.trim_curve(loop.first_curve + i).points;
            pieces.emplace_back(points.begin(), points.end());
        }
        loops.emplace_back(std::move(pieces));
    }
    if (loops.empty()) loops.push_back(rectangle(domain));
    return loops;
}

opencascade::handle<Geom2d_BezierCurve> occt_curve(const BorderPiece& piece) {
    const int count = static_cast<int>(piece.size());
    TColgp_Array1OfPnt2d poles(1, count);
    TColStd_Array1OfReal weights(1, count);
    for (int i = 0; i < count; ++i) {
        const Vec3& p = piece[static_cast<std::size_t>(i)];
        poles(i + 1) = gp_Pnt2d(p.x / p.z, p.y / p.z);
        weights(i + 1) = p.z;
    }
    return new Geom2d_BezierCurve(poles, weights);
}

/// Makes OpenCASCADE's face of a surface and its borders.
class FaceBuilder {
public:
    explicit FaceBuilder(const opencascade::handle<ModelSurface>& surface) : surface_(surface) {
        builder_.MakeFace(face_, surface, Precision::Confusion());
    }

    /// Adds a border; `hole`: it runs around what is no material.
    void add(const BorderLoop& loop, bool hole) {
        const std::size_t count = loop.pieces.size();
        std::vector<TopoDS_Vertex> corners;
        for (const BorderPiece& piece : loop.pieces) corners.push_back(corner(piece.front()));
        TopoDS_Wire wire;
        builder_.MakeWire(wire);
        for (std::size_t i = 0; i < count; ++i)
            builder_.Add(wire, edge(loop.pieces[i], corners[i], corners[(i + 1) % count]));
        wire.Closed(true);
        const bool clockwise = loop.area() < 0;
        builder_.Add(face_, clockwise == hole ? wire : TopoDS::Wire(wire.Reversed()));
    }

    const TopoDS_Face& face() const { return face_; }

private:
    TopoDS_Vertex corner(const Vec3& point) {
        const Vec3 p = surface_->position({point.x / point.z, point.y / point.z});
        TopoDS_Vertex vertex;
        builder_.MakeVertex(vertex, gp_Pnt(p.x, p.y, p.z), Precision::Confusion());
        return vertex;
    }
    TopoDS_Edge edge(const BorderPiece& piece, const TopoDS_Vertex& begin,
                     const TopoDS_Vertex& end) {
        TopoDS_Edge edge;
        builder_.MakeEdge(edge);
        const bool is_degenerate = is_point(piece);
        if (!is_degenerate) builder_.UpdateEdge(edge, space_curve(piece), Precision::Confusion());
        builder_.UpdateEdge(edge, occt_curve(piece), surface_, TopLoc_Location(),
                            Precision::Confusion());
        builder_.Add(edge, begin.Oriented(TopAbs_FORWARD));
        builder_.Add(edge, end.Oriented(TopAbs_REVERSED));
        builder_.Range(edge, 0, 1);
        builder_.Degenerated(edge, is_degenerate);
        return edge;
    }
    /// A spline through points of the piece in space, by which the mesher divides it. Corners of
    /// triangles are found by their parameters, not on it.
    opencascade::handle<Geom_BSplineCurve> space_curve(const BorderPiece& piece) const {
        constexpr int spans = 24;
        const opencascade::handle<TColgp_HArray1OfPnt> points =
            new TColgp_HArray1OfPnt(1, spans + 1);
        const opencascade::handle<TColStd_HArray1OfReal> parameters =
            new TColStd_HArray1OfReal(1, spans + 1);
        for (int i = 0; i <= spans; ++i) {
            const Vec3 p = surface_->position(evaluate({piece}, double(i) / spans, 0)[0]);
            points->SetValue(i + 1, gp_Pnt(p.x, p.y, p.z));
            parameters->SetValue(i + 1, double(i) / spans);
        }
        GeomAPI_Interpolate spline(points, parameters, false, Precision::SquareConfusion());
        spline.Perform();
        return spline.Curve();
    }
    /// Whether a piece is one point in space, as at a pole.
    bool is_point(const BorderPiece& piece) const {
        constexpr int samples = 4;
        const Vec3 first = surface_->position(evaluate({piece}, 0, 0)[0]);
        for (int i = 1; i <= samples; ++i) {
            const Vec2 uv = evaluate({piece}, double(i) / samples, 0)[0];
            if ((surface_->position(uv) - first).length() > Precision::Confusion()) return false;
        }
        return true;
    }

    opencascade::handle<ModelSurface> surface_;
    BRep_Builder builder_;
    TopoDS_Face face_;
};

} // namespace

TopoDS_Face occt_face(const opencascade::handle<ModelSurface>& surface, const SurfaceModel& model,
                      const Face& face) {
    const std::vector<BorderLoop> loops = loops_of(model, face, surface->domain());
    FaceBuilder builder(surface);
    for (const BorderLoop& loop : loops) {
        const auto around = std::count_if(loops.begin(), loops.end(), [&](const BorderLoop& other) {
            return &other != &loop && other.surrounds(loop.polygon.front());
        });
        builder.add(loop, around % 2 == 1);
    }
    return builder.face();
}

} // namespace keiko::cad
