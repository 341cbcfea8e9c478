#include "keiko/import/cad/face_conversion.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/import/cad/shape_places.h"
#include "keiko/import/cad/surface_patches.h"

#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Plane.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

#include <array>
#include <cmath>
#include <sstream>

namespace keiko::cad {

namespace {

opencascade::handle<Geom_Surface> surface_of(const TopoDS_Face& face) {
    TopLoc_Location location;
    return BRep_Tool::Surface(face, location);
}

bool has_p_curve(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    double first = 0, last = 0;
    return !BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull();
}

bool used_twice(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    int uses = 0;
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) uses += e.Current().IsSame(edge);
    return uses > 1;
}

std::vector<TopoDS_Edge> complete_p_curves(const TopoDS_Face& face) {
    std::vector<TopoDS_Edge> built;
    const opencascade::handle<Geom_Surface> surface = surface_of(face);
    if (surface.IsNull()) return built;
    const bool plane = untrimmed(surface)->IsKind(STANDARD_TYPE(Geom_Plane));
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(e.Current());
        if (plane) {
            BRepLib::BuildPCurveForEdgeOnPlane(edge, face);
        } else if (!has_p_curve(edge, face)) {
            ShapeFix_Edge().FixAddPCurve(edge, face, used_twice(edge, face),
                                         BRep_Tool::Tolerance(edge));
            if (has_p_curve(edge, face)) built.push_back(edge);
        }
    }
    return built;
}

BezierPatchView view(const SurfacePatch& patch) {
    return {patch.degree_u, patch.degree_v, patch.points};
}

/// In each direction of a patch: where it is held against the surface.
constexpr std::array<double, 3> places{0, 0.37, 1};

using BasisValues = std::array<BernsteinRow, places.size()>;

BasisValues basis_at_places(int degree) {
    BasisValues rows{};
    for (std::size_t k = 0; k < places.size(); ++k) {
        rows[k][0] = 1;
        for (int n = 1; n <= degree; ++n)
            raise_degree(rows[k], static_cast<std::size_t>(n), places[k]);
    }
    return rows;
}

/// The point of a patch by the values of its basis polynomials there.
Vec3 point(const BezierPatchView& patch, const BernsteinRow& in_u, const BernsteinRow& in_v) {
    Vec4 sum(0);
    for (int i = 0; i <= patch.degree_u; ++i)
        for (int j = 0; j <= patch.degree_v; ++j)
            sum += patch.point(i, j) *
                   (in_u[static_cast<std::size_t>(i)] * in_v[static_cast<std::size_t>(j)]);
    return euclidean(sum);
}

/// A NaN is larger than any number, so that none is passed over.
double larger(double a, double b) {
    return a >= b || std::isnan(a) ? a : b;
}

double largest_deviation(const SurfacePatch& patch, const Geom_Surface& surface) {
    const BasisValues in_u = basis_at_places(patch.degree_u);
    const BasisValues in_v = basis_at_places(patch.degree_v);
    double worst = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < places.size(); ++j) {
            gp_Pnt p;
            surface.D0(patch.map_u.to_face(places[i]), patch.map_v.to_face(places[j]), p);
            const double distance =
                (point(view(patch), in_u[i], in_v[j]) - Vec3(p.X(), p.Y(), p.Z())).length();
            worst = larger(worst, distance);
        }
    return worst;
}

/// Largest distance between the patches and the CAD surface at points of each patch.
double largest_deviation(const std::vector<SurfacePatch>& patches, const Geom_Surface& surface) {
    double worst = 0;
    for (const SurfacePatch& patch : patches)
        worst = larger(worst, largest_deviation(patch, surface));
    return worst;
}

/// Throws where a damaged file has left numbers that no computation survives.
void check(const FaceLoops& trim) {
    for (const Chain& loop : trim.loops)
        for (const LoopCurve& curve : loop)
            for (const Vec3& p : curve.points)
                if (!std::isfinite(p.x + p.y + p.z) || !(p.z > 0))
                    throw Error("", "", "its trim curves are not finite with positive weights");
    for (const Repair& repair : trim.log.repairs())
        if (!std::isfinite(repair.size)) throw Error("", "", "its edges are infinitely far apart");
}

/// mm from the origin: as far as rays and the points of Keiko's own files may lie.
constexpr double farthest = 1e15;

/// Throws when the patches are not the surface.
void check(const SurfacePatches& converted, const Geom_Surface& surface) {
    Box3 box;
    for (const SurfacePatch& patch : converted.patches) {
        for (const Vec4& p : patch.points)
            if (!std::isfinite(p.x + p.y + p.z + p.w) || !(p.w > 0))
                throw Error("", "", "its control points are not finite with positive weights");
        box.extend(hull_bounds(view(patch)));
    }
    const double magnitude = std::max(box.lower.length(), box.upper.length());
    if (!(magnitude <= farthest)) throw Error("", "", "it reaches beyond 1e15 mm");
    // Far from the origin, coordinates themselves are only good to their own rounding.
    const double tolerance = 1e-9 * box.size() + 1e-13 * magnitude + 2 * converted.approximated;
    const double deviation = largest_deviation(converted.patches, surface);
    if (deviation <= tolerance) return;
    std::ostringstream text;
    text << "its patches are " << deviation << " mm off the surface";
    throw Error("", "", text.str());
}

} // namespace

ConvertedFace convert_face(const TopoDS_Face& face, EdgeTable& edges,
                           const std::vector<TopoDS_Edge>& built) {
    TopLoc_Location location;
    const opencascade::handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
    if (surface.IsNull()) throw Error("", "", "it has no surface");
    ConvertedFace result{{}, 0, face_loops(face, edges, built)};
    SurfacePatches converted = surface_patches(surface, result.trim.domain);
    if (converted.patches.empty()) throw Error("", "", "its trim loops lie outside of its surface");
    check(result.trim);
    check(converted, *untrimmed(surface));
    const Affine to_part = affine(location.Transformation());
    if (!to_part.is_identity())
        for (SurfacePatch& patch : converted.patches)
            for (Vec4& p : patch.points) p = to_part.homogeneous(p);
    result.patches = std::move(converted.patches);
    result.approximated = converted.approximated;
    return result;
}

std::string surface_kind(const TopoDS_Face& face) {
    const opencascade::handle<Geom_Surface> surface = surface_of(face);
    return surface.IsNull() ? "none" : surface_kind(surface);
}

namespace {

/// Collects the faces of a shape. Shapes that share a face have it once; a shape that a compound
/// lists twice at one place is there twice.
class FaceCollector {
public:
    void collect(const TopoDS_Shape& shape) {
        if (shape.ShapeType() == TopAbs_COMPOUND) {
            for (TopoDS_Iterator part(shape); part.More(); part.Next()) collect(part.Value());
            return;
        }
        const bool again = !shapes_.Add(shape);
        TopTools_IndexedMapOfShape own;
        TopExp::MapShapes(shape, TopAbs_FACE, own);
        for (int i = 1; i <= own.Extent(); ++i)
            if (seen_.Add(own(i)) || again) faces_.push_back(TopoDS::Face(own(i)));
    }

    const std::vector<TopoDS_Face>& faces() const { return faces_; }

private:
    TopTools_MapOfShape shapes_, seen_;
    std::vector<TopoDS_Face> faces_;
};

std::vector<FaceResult> faces_of(const CadDocument& document) {
    std::vector<FaceCollector> parts(document.parts.size());
    std::size_t count = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        parts[p].collect(document.parts[p].shape);
        count += parts[p].faces().size();
    }
    std::vector<FaceResult> results(count);
    auto result = results.begin();
    for (std::size_t p = 0; p < parts.size(); ++p)
        for (const TopoDS_Face& face : parts[p].faces())
            result->shape = face, result->part = p, ++result;
    return results;
}

/// Tells the share of a stage that is itself a share of "import".
Job share_of(const Job& job, double from, double to) {
    Job share = job;
    if (job.progress)
        share.progress = [&job, from, to](const Progress& p) {
            job.report("import", from + (to - from) * p.fraction);
        };
    return share;
}

/// Loops that needed repair tell nothing of the wires they were made from.
KnownLoops known_loops(const FaceResult& face) {
    const bool whole = face.converted && face.converted->trim.loops.size() == 1 &&
                       face.converted->trim.log.empty();
    return whole && face.shape.NbChildren() == 1 && !face.shape.Infinite()
               ? KnownLoops::one_forward_loop
               : KnownLoops::nothing;
}

void convert(FaceResult& face, const CadDocument& document, const std::vector<TopoDS_Edge>& built) {
    try {
        const auto lost = document.misread.find(face.shape.TShape().get());
        if (lost != document.misread.end()) throw Error("", "", lost->second);
        face.converted = convert_face(face.shape, face.edges, built);
    } catch (...) {
        face.loss = current_failure();
    }
    if (!surface_of(face.shape).IsNull()) face.fault = fault_of(face.shape, known_loops(face));
}

} // namespace

std::vector<FaceResult> convert_faces(const CadDocument& document, const Job& job, double from,
                                      double to) {
    std::vector<FaceResult> faces = faces_of(document);
    std::vector<std::vector<TopoDS_Edge>> built;
    for (const FaceResult& face : faces) {
        job.check();
        built.push_back(complete_p_curves(face.shape));
    }
    parallel_for(faces.size(), share_of(job, from, to), "import",
                 [&](std::size_t i) { convert(faces[i], document, built[i]); });
    return faces;
}

} // namespace keiko::cad
