#include "keiko/inspect/structure/face_structure.h"

#include <algorithm>
#include <vector>

namespace keiko {
namespace {

/// Border curves that follow each other on one edge of the file.
struct Run {
    FaceKey face;
    std::vector<BoundaryInterval> curves;
};

bool is_side(const BoundaryInterval& border) {
    return border.curve >= natural_side;
}

/// Index of the edge that a border curve lies on; no_index if it is none.
std::uint32_t edge_of(const SurfaceModel& model, const BoundaryInterval& border) {
    return is_side(border) ? no_index : model.trim_curves[border.curve].edge;
}

/// True if a border is no edge of the file: it closes a loop, or it is a point. Models without
/// edges have a border curve in place of each.
bool is_no_edge(const SurfaceModel& model, const BoundaryInterval& border) {
    if (is_side(border) || model.edges.empty()) return false;
    const std::uint32_t edge = edge_of(model, border);
    return edge == no_index || model.edges[edge].degenerate;
}

bool goes_on(const SurfaceModel& model, const Run& run, const BoundaryInterval& next) {
    const BoundaryInterval& last = run.curves.back();
    const std::uint32_t edge = edge_of(model, next);
    return edge != no_index && run.face == FaceKey{next.instance, next.face} &&
           edge == edge_of(model, last) && next.curve == last.curve + 1;
}

std::vector<Run> runs_of(const ModelBorders& borders) {
    std::vector<Run> runs;
    for (const BoundaryInterval& border : borders.curves.all()) {
        if (is_no_edge(borders.model, border)) continue;
        if (!runs.empty() && goes_on(borders.model, runs.back(), border))
            runs.back().curves.push_back(border);
        else
            runs.push_back({{border.instance, border.face}, {border}});
    }
    return runs;
}

/// Length of the polyline through places of a run, mm: the run is no shorter.
double polyline_length(const BoundaryCurves& curves, const Run& run, int steps) {
    double length = 0;
    for (const BoundaryInterval& border : run.curves) {
        const SurfaceCurve curve = curves.curve(border);
        Vec3 last = curve.at(border.begin).position;
        for (int i = 1; i <= steps; ++i) {
            const double t = border.begin + (border.end - border.begin) * i / steps;
            const Vec3 next = curve.at(t).position;
            length += (next - last).length(), last = next;
        }
    }
    return length;
}

MeasuredValue measured(const BoundaryCurves& curves, const Run& run, double limit) {
    const double coarse = polyline_length(curves, run, 32);
    const double length = polyline_length(curves, run, 64);
    const BoundaryInterval& middle = run.curves[run.curves.size() / 2];
    const double t = run.curves.size() % 2 ? (middle.begin + middle.end) / 2 : middle.begin;
    MeasuredValue worst{
        length, length - coarse, limit, curves.curve(middle).at(t).position, Verdict::pass, true};
    // The polyline is shorter than the edge, so that one over the limit passes.
    if (length < limit)
        worst.verdict = length + worst.bound < limit ? Verdict::fail : Verdict::undecided;
    return worst;
}

/// mm: shorter sides of a domain are points of its surface, such as poles.
constexpr double side_point = 1e-9;

} // namespace

std::map<FaceKey, MeasuredValue> shortest_edges(const ModelBorders& borders, double limit,
                                                const Job& job) {
    std::map<FaceKey, MeasuredValue> shortest;
    for (const Run& run : runs_of(borders)) {
        job.check();
        const auto found = shortest.find(run.face);
        constexpr int few = 2;
        const double least = polyline_length(borders.curves, run, few);
        if (found != shortest.end() && least >= std::max(limit, found->second.value)) continue;
        const MeasuredValue value = measured(borders.curves, run, limit);
        if (is_side(run.curves.front()) && value.value < side_point) continue;
        if (found == shortest.end())
            shortest.emplace(run.face, value);
        else if (value.value < found->second.value)
            found->second = value;
    }
    return shortest;
}

std::optional<MeasuredValue> face_size(const ModelBorders& borders, const FaceKey& face,
                                       const Vec3& place, double limit) {
    const double size = borders.sizes.of(face.first, face.second);
    if (!(size > 0)) return std::nullopt;
    const Verdict verdict = size < limit ? Verdict::fail : Verdict::pass;
    return MeasuredValue{size, 0, limit, place, verdict, true};
}

} // namespace keiko
