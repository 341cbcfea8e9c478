#include "keiko/inspect/structure/edge_structure.h"

#include "keiko/base/units.h"
#include "keiko/inspect/basics/approximation_error.h"
#include "keiko/inspect/structure/edge_runs.h"
#include "keiko/inspect/structure/least_value.h"

#include <algorithm>
#include <vector>

namespace keiko {
namespace {

MeasuredValue at_most(double value, double limit, const Vec3& place) {
    return {value, 0, limit, place, judge(value, 0, limit), false};
}

/// Measures edges, each in the structure of its face.
class EdgeMeasures {
public:
    EdgeMeasures(const ModelBorders& borders, const std::map<FaceKey, StructureLimits>& limits)
        : borders_(borders), model_(borders.model), limits_(limits) {}

    void add_run(const EdgeSide& run) {
        const FaceKey key{run.face.instance, run.face.face};
        const auto limits = limits_.find(key);
        if (limits == limits_.end() || run.edge == no_index) return;
        EdgeStructure& of = found_[key];
        if (limits->second.edge_degree) measure_degree(run, *limits->second.edge_degree, of);
        if (run.curves.size() < 2) return;
        if (limits->second.edge_angle) measure_kinks(run, *limits->second.edge_angle, of);
        if (limits->second.edge_knot_distance)
            measure_curves(run, *limits->second.edge_knot_distance, of);
    }

    void add_loop(const std::vector<BoundaryInterval>& loop) {
        const FaceKey key{loop.front().instance, loop.front().face};
        const auto limits = limits_.find(key);
        if (limits == limits_.end() || !limits->second.edge_gap) return;
        const double widest = widest_bridge(key);
        for (std::size_t i = 0; i < loop.size(); ++i)
            if (has_edge(loop[i])) measure_gap(loop, i, widest, *limits->second.edge_gap);
    }

    std::map<FaceKey, EdgeStructure> take() { return std::move(found_); }

private:
    bool has_edge(const BoundaryInterval& border) const {
        return border.curve < natural_side && model_.trim_curves[border.curve].edge != no_index;
    }
    SurfaceCurve curve(const BoundaryInterval& border) const {
        return borders_.curves.curve(border);
    }

    void measure_degree(const EdgeSide& run, int limit, EdgeStructure& of) const {
        for (const BoundaryInterval& border : run.curves)
            keep_worse(of.degree, at_most(model_.trim_curves[border.curve].degree, limit,
                                          curve(border).at(0.5).position));
    }

    void measure_kinks(const EdgeSide& run, double limit, EdgeStructure& of) const {
        for (std::size_t i = 0; i + 1 < run.curves.size(); ++i) {
            const SurfaceCurve::Point end = curve(run.curves[i]).at(1);
            const SurfaceCurve::Point begin = curve(run.curves[i + 1]).at(0);
            if (!(end.first.length() > 0 && begin.first.length() > 0)) continue;
            keep_worse(of.angle, at_most(radians_to_degrees(angle_between(end.first, begin.first)),
                                         limit, end.position));
        }
    }

    void measure_curves(const EdgeSide& run, double limit, EdgeStructure& of) const {
        for (const BoundaryInterval& border : run.curves) {
            const EdgeSide one{run.face, run.edge, {border}};
            const double coarse = polyline_length(borders_.curves, one, 4);
            if (coarse > limit && of.knot_distance && coarse > of.knot_distance->value) continue;
            const double length = polyline_length(borders_.curves, one, 64);
            const MeasuredValue found =
                at_least(length, length - coarse, limit, curve(border).at(0.5).position);
            of.knot_distance = of.knot_distance ? lesser_of(*of.knot_distance, found) : found;
        }
    }

    /// mm: the widest gap of a face that the import has bridged by a straight piece.
    double widest_bridge(const FaceKey& key) const {
        double widest = 0;
        for (const Repair& repair : model_.repairs)
            if (repair.face == model_.faces[key.second].id &&
                (repair.kind == RepairKind::gap_bridged || repair.kind == RepairKind::loop_closed))
                widest = std::max(widest, repair.size);
        return widest;
    }

    /// Measures from the end of an edge to the begin of the next one in its loop. The straight
    /// piece between them is the gap if the import states that it has bridged one as wide; others,
    /// as between the rings of a band, belong to the form of the loop.
    void measure_gap(const std::vector<BoundaryInterval>& loop, std::size_t i, double widest,
                     double limit) {
        std::size_t next = (i + 1) % loop.size();
        const bool bridged = !has_edge(loop[next]);
        if (bridged) next = (next + 1) % loop.size();
        if (next == i || !has_edge(loop[next])) return;
        const Vec3 end = curve(loop[i]).at(1).position, begin = curve(loop[next]).at(0).position;
        const double scale = scale_of(model_.instances[loop[i].instance]);
        constexpr double slack = 2; // the import measures along the surface
        const double gap = (begin - end).length();
        if (bridged && gap > slack * scale * widest) return;
        const FaceKey key{loop[i].instance, loop[i].face};
        keep_worse(found_[key].gap, at_most(gap, limit, (begin + end) / 2));
    }

    const ModelBorders& borders_;
    const SurfaceModel& model_;
    const std::map<FaceKey, StructureLimits>& limits_;
    std::map<FaceKey, EdgeStructure> found_;
};

} // namespace

std::map<FaceKey, EdgeStructure> edge_structures(const ModelBorders& borders,
                                                 const std::map<FaceKey, StructureLimits>& limits,
                                                 const Job& job) {
    EdgeMeasures measures(borders, limits);
    if (limits.empty() || borders.model.edges.empty()) return {};
    for (const EdgeSide& run : edge_runs(borders)) {
        job.check();
        measures.add_run(run);
    }
    for (const std::vector<BoundaryInterval>& loop : borders.curves.loops()) {
        job.check();
        if (loop.front().curve < natural_side) measures.add_loop(loop);
    }
    return measures.take();
}

} // namespace keiko
