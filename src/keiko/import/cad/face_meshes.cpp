#include "keiko/import/cad/face_meshes.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/import/cad/model_surface.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>

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
    bool surrounds(const Vec2& p) const {
        bool within = false;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
                within = !within;
        }
        return within;
    }
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

TopoDS_Face occt_face(const opencascade::handle<ModelSurface>& surface,
                      const std::vector<BorderLoop>& loops) {
    FaceBuilder builder(surface);
    for (const BorderLoop& loop : loops) {
        const auto around = std::count_if(loops.begin(), loops.end(), [&](const BorderLoop& other) {
            return &other != &loop && other.surrounds(loop.polygon.front());
        });
        builder.add(loop, around % 2 == 1);
    }
    return builder.face();
}

/// Largest distance of the surface from the triangles at their middles and those of their edges.
double deviation_of(const FaceMesh& mesh, const ModelSurface& surface) {
    std::vector<Vec3> corners;
    for (const Vec2& uv : mesh.uv) corners.push_back(surface.position(uv));
    double largest = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        for (const auto& [i, j] : {std::pair(a, b), {b, c}, {c, a}}) {
            const Vec3 middle = surface.position((mesh.uv[i] + mesh.uv[j]) * 0.5);
            largest = std::max(largest, segment_distance(corners[i], corners[j], middle));
        }
        const Vec3 middle = surface.position((mesh.uv[a] + mesh.uv[b] + mesh.uv[c]) / 3);
        const Vec3 normal = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
        if (normal.length() > 0)
            largest =
                std::max(largest, std::abs((middle - corners[a]).dot(normal)) / normal.length());
    }
    return largest;
}

FaceMesh triangles_of(const TopoDS_Face& face) {
    TopLoc_Location location;
    const auto triangulation = BRep_Tool::Triangulation(face, location);
    FaceMesh mesh;
    if (triangulation.IsNull() || triangulation->NbTriangles() == 0 ||
        !triangulation->HasUVNodes()) {
        mesh.problem = "OpenCASCADE makes no triangles of it";
        return mesh;
    }
    for (int i = 1; i <= triangulation->NbNodes(); ++i) {
        const gp_Pnt2d uv = triangulation->UVNode(i);
        mesh.uv.emplace_back(uv.X(), uv.Y());
    }
    for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
        int a = 0, b = 0, c = 0;
        triangulation->Triangle(i).Get(a, b, c);
        const auto index = [](int node) { return static_cast<std::uint32_t>(node - 1); };
        mesh.triangles.push_back({index(a), index(b), index(c)});
    }
    return mesh;
}

FaceMesh meshed(const TopoDS_Face& face, double deflection) {
    constexpr double turn = 0.35; // radians between neighbouring edges and normals, for shading
    IMeshTools_Parameters parameters;
    parameters.Deflection = deflection, parameters.Angle = turn;
    BRepMesh_IncrementalMesh mesher(face, parameters);
    FaceMesh mesh = triangles_of(face);
    if (!mesh.problem.empty())
        mesh.problem += " (status " + std::to_string(mesher.GetStatusFlags()) + ")";
    return mesh;
}

FaceMesh mesh_of(const SurfaceModel& model, const Face& face, double deviation) {
    constexpr int most_trials = 6;
    const opencascade::handle<ModelSurface> surface = new ModelSurface(model, face);
    const std::vector<BorderLoop> loops = loops_of(model, face, surface->domain());
    FaceMesh best;
    double deflection = deviation;
    for (int trial = 0; trial < most_trials; ++trial, deflection /= 2) {
        FaceMesh mesh = meshed(occt_face(surface, loops), deflection);
        if (!mesh.problem.empty()) return trial == 0 ? mesh : best;
        mesh.deviation = deviation_of(mesh, *surface);
        if (trial == 0 || mesh.deviation < best.deviation) best = std::move(mesh);
        if (best.deviation <= deviation) break;
    }
    return best;
}

} // namespace

ModelMesh mesh_faces(const SurfaceModel& model, double deviation, const Job& job) {
    ModelMesh mesh(model.faces.size());
    parallel_for(mesh.size(), job, "mesh", [&](std::size_t f) {
        try {
            mesh[f] = mesh_of(model, model.faces[f], deviation);
        } catch (const Standard_Failure& failure) {
            mesh[f].problem = std::string("OpenCASCADE: ") + failure.GetMessageString();
        }
    });
    return mesh;
}

} // namespace keiko::cad
