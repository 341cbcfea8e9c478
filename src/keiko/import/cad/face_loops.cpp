#include "keiko/base/error.h"
#include "keiko/import/cad/curve_spans.h"
#include "keiko/import/cad/edge_distance.h"
#include "keiko/import/cad/face_conversion.h"
#include "keiko/import/cad/surface_patches.h"
#include "keiko/import/cad/trim_chains.h"

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace keiko::cad {

namespace {

bool is_cycle(const std::vector<TopoDS_Edge>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const TopoDS_Edge& next = edges[(i + 1) % edges.size()];
        if (!TopExp::LastVertex(edges[i], true).IsSame(TopExp::FirstVertex(next, true)))
            return false;
    }
    return true;
}

bool uses_an_edge_twice(const std::vector<TopoDS_Edge>& edges) {
    TopTools_MapOfShape seen;
    return std::any_of(edges.begin(), edges.end(),
                       [&](const TopoDS_Edge& edge) { return !seen.Add(edge); });
}

/// The face's parameters where an edge begins and ends.
std::array<double, 4> ends(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    gp_Pnt2d first, last;
    BRep_Tool::UVPoints(edge, face, first, last);
    if (edge.Orientation() == TopAbs_REVERSED) std::swap(first, last);
    return {first.X(), first.Y(), last.X(), last.Y()};
}

/// Turns a cycle to begin at the edge with the least parameters. In OpenCASCADE's reader the begin
/// of a wire that uses an edge twice depends on the memory addresses of a run.
void begin_at_least_parameters(std::vector<TopoDS_Edge>& cycle, const TopoDS_Face& face) {
    const auto first = std::min_element(
        cycle.begin(), cycle.end(),
        [&](const TopoDS_Edge& a, const TopoDS_Edge& b) { return ends(a, face) < ends(b, face); });
    std::rotate(cycle.begin(), first, cycle.end());
}

std::vector<TopoDS_Edge> ordered_edges(const TopoDS_Wire& wire, const TopoDS_Face& face) {
    std::vector<TopoDS_Edge> all, chained;
    for (TopExp_Explorer e(wire, TopAbs_EDGE); e.More(); e.Next())
        all.push_back(TopoDS::Edge(e.Current()));
    for (BRepTools_WireExplorer e(wire, face); e.More() && chained.size() <= all.size(); e.Next())
        chained.push_back(e.Current());
    std::vector<TopoDS_Edge>& edges = chained.size() == all.size() ? chained : all;
    if (uses_an_edge_twice(edges) && is_cycle(edges)) begin_at_least_parameters(edges, face);
    return edges;
}

using CurveHandle = opencascade::handle<Geom2d_Curve>;

ParameterSpace parameter_space(const TopoDS_Face& face) {
    TopLoc_Location location;
    const opencascade::handle<Geom_Surface> stored = BRep_Tool::Surface(face, location);
    const opencascade::handle<Geom_Surface> surface = untrimmed(stored);
    ParameterSpace space;
    space.period = periods(*surface);
    space.natural = natural_domain(*stored);
    space.wrap = space.period;
    if (surface->IsUClosed() && space.wrap.x == 0) space.wrap.x = space.natural.extent().x;
    if (surface->IsVClosed() && space.wrap.y == 0) space.wrap.y = space.natural.extent().y;
    if (const auto cone = opencascade::handle<Geom_ConicalSurface>::DownCast(surface))
        space.apex_v = -cone->RefRadius() / std::sin(cone->SemiAngle());
    if (surface->IsKind(STANDARD_TYPE(Geom_SphericalSurface))) space.continuation = 0;
    space.point = [surface](const Vec2& at) {
        const gp_Pnt p = surface->Value(at.x, at.y);
        return Vec3(p.X(), p.Y(), p.Z());
    };
    return space;
}

/// mm, of an edge that is wholly within its own tolerance of a point, but no degenerate one.
std::optional<double> tiny_size(const TopoDS_Edge& edge) {
    double first = 0, last = 0;
    const auto curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull() || BRep_Tool::Degenerated(edge)) return std::nullopt;
    const gp_Pnt begin = curve->Value(first);
    const double size = std::max(begin.Distance(curve->Value((first + last) / 2)),
                                 begin.Distance(curve->Value(last)));
    return size <= BRep_Tool::Tolerance(edge) ? std::optional(size) : std::nullopt;
}

/// mm from its curve on the surface at which an edge in space lies off the surface. OpenCASCADE
/// itself projects the edges that it reads, without a word.
constexpr double far_off = 0.1;

bool bounds_material(const TopoDS_Edge& edge) {
    return edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
}

class LoopReader {
public:
    LoopReader(const TopoDS_Face& face, EdgeTable& edges, std::vector<TopoDS_Edge> built)
        : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))),
          edges_(edges),
          built_(std::move(built)),
          space_(parameter_space(face)) {}

    FaceLoops read() {
        std::vector<std::vector<Chain>> wires;
        for (TopoDS_Iterator it(face_); it.More(); it.Next())
            if (it.Value().ShapeType() == TopAbs_WIRE) {
                auto uses = edge_uses(TopoDS::Wire(it.Value()));
                if (!uses.empty()) wires.push_back(std::move(uses));
            }
        set_scale(wires);
        std::vector<Chain> chains;
        for (auto& uses : wires)
            for (Chain& chain : chain_wire(std::move(uses), space_, result_.log))
                chains.push_back(std::move(chain));
        ClosedLoops closed = close_loops(std::move(chains), space_, result_.log);
        result_.loops = std::move(closed.loops);
        result_.domain = closed.domain;
        for (std::size_t i = backward_loops(result_.loops); i > 0; --i)
            result_.log.add(RepairKind::loop_runs_backwards);
        return std::move(result_);
    }

private:
    std::vector<Chain> edge_uses(const TopoDS_Wire& wire) {
        std::vector<Chain> uses;
        bool only_points = true;
        for (const TopoDS_Edge& edge : ordered_edges(wire, face_)) {
            if (!bounds_material(edge)) {
                result_.log.add(RepairKind::edge_dropped);
                continue;
            }
            uses.push_back(edge_use(edge));
            only_points = only_points && BRep_Tool::Degenerated(edge);
        }
        // A vertex loop bounds nothing unless it runs around a pole.
        if (only_points && !uses.empty() && !runs_around(uses)) {
            result_.log.add(RepairKind::point_loop_dropped);
            return {};
        }
        return uses;
    }

    bool runs_around(const std::vector<Chain>& uses) const {
        const Vec2 way = end_of(uses.back()) - begin_of(uses.front());
        return (space_.wrap.x > 0 && std::abs(way.x) > space_.wrap.x / 2) ||
               (space_.wrap.y > 0 && std::abs(way.y) > space_.wrap.y / 2);
    }

    Chain edge_use(const TopoDS_Edge& edge) {
        const std::uint32_t number = edges_.number_of(edge);
        double first = 0, last = 0;
        const CurveHandle curve = p_curve(edge, number, first, last);
        const auto converted = curve_spans(curve, first, last);
        if (converted.approximated > 0)
            result_.log.add(RepairKind::p_curve_approximated,
                            length_of(converted.approximated, curve->Value(first)));
        if (const auto size = tiny_size(edge)) result_.log.add(RepairKind::tiny_edge, *size);
        Chain chain;
        for (const auto& span : converted.spans) chain.push_back({span.points, number});
        if (edge.Orientation() == TopAbs_REVERSED) reverse(chain);
        result_.edge_uses.push_back(number);
        return chain;
    }

    CurveHandle p_curve(const TopoDS_Edge& edge, std::uint32_t number, double& first,
                        double& last) {
        CurveHandle curve = BRep_Tool::CurveOnSurface(edge, face_, first, last);
        const std::string name = "edge " + std::to_string(number + 1) + " of the face";
        if (curve.IsNull())
            throw Error("", "", name + " has no p-curve and none could be projected");
        const auto built = std::find_if(built_.begin(), built_.end(),
                                        [&](const TopoDS_Edge& e) { return e.IsSame(edge); });
        const bool is_built = built != built_.end();
        if (is_built) built_.erase(built); // a seam comes twice
        if (!(first < last)) throw Error("", "", name + " has an empty parameter range");
        log_distance(edge, {curve, first, last}, is_built);
        return curve;
    }

    void log_distance(const TopoDS_Edge& edge, const PCurve& on_face, bool is_built) {
        if (!is_built && BRep_Tool::Tolerance(edge) <= far_off) return;
        const double along = distance_along_edge(edge, face_, on_face);
        if (is_built) return result_.log.add(RepairKind::p_curve_built, along);
        if (along <= far_off) return;
        const double off = distance_from_edge(edge, face_, on_face);
        if (off > far_off) result_.log.add(RepairKind::p_curve_built, off);
    }

    void set_scale(const std::vector<std::vector<Chain>>& wires) {
        Box2 box;
        for (const auto& uses : wires)
            for (const Chain& use : uses) box.extend(tight_bounds(use));
        if (box.empty()) return;
        const Vec2 extent = box.extent();
        space_.scale = {extent.x > 0 ? extent.x : 1, extent.y > 0 ? extent.y : 1};
    }

    /// mm of a length in parameters at a place.
    double length_of(double parameters, const gp_Pnt2d& at) const {
        const Vec2 from(at.X(), at.Y());
        return std::max(space_.distance(from, from + Vec2(parameters, 0)),
                        space_.distance(from, from + Vec2(0, parameters)));
    }

    TopoDS_Face face_;
    EdgeTable& edges_;
    std::vector<TopoDS_Edge> built_;
    ParameterSpace space_;
    FaceLoops result_;
};

} // namespace

FaceLoops face_loops(const TopoDS_Face& face, EdgeTable& edges,
                     const std::vector<TopoDS_Edge>& built) {
    return LoopReader(face, edges, built).read();
}

} // namespace keiko::cad
