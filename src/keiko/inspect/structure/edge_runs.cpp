#include "keiko/inspect/structure/edge_runs.h"

namespace keiko {
namespace {

/// Index of the edge that a border curve lies on; no_index if it is none.
std::uint32_t edge_of(const SurfaceModel& model, const BoundaryInterval& border) {
    return border.curve >= natural_side ? no_index : model.trim_curves[border.curve].edge;
}

/// True if a border is no edge of the file: it closes a loop, or it is a point.
bool is_no_edge(const SurfaceModel& model, const BoundaryInterval& border) {
    if (border.curve >= natural_side || model.edges.empty()) return false;
    const std::uint32_t edge = edge_of(model, border);
    return edge == no_index || model.edges[edge].degenerate;
}

bool goes_on(const SurfaceModel& model, const EdgeSide& run, const BoundaryInterval& next) {
    const std::uint32_t edge = edge_of(model, next);
    return edge != no_index && run.face == PlacedFace{next.instance, next.face} &&
           edge == run.edge && next.curve == run.curves.back().curve + 1;
}

} // namespace

std::vector<EdgeSide> edge_runs(const ModelBorders& borders) {
    const SurfaceModel& model = borders.model;
    std::vector<EdgeSide> runs;
    for (const BoundaryInterval& border : borders.curves.all()) {
        if (is_no_edge(model, border)) continue;
        if (!runs.empty() && goes_on(model, runs.back(), border))
            runs.back().curves.push_back(border);
        else
            runs.push_back({{border.instance, border.face}, edge_of(model, border), {border}});
    }
    return runs;
}

std::vector<Vec3> border_places(const BoundaryCurves& curves,
                                std::span<const BoundaryInterval> borders) {
    constexpr int steps = 8;
    std::vector<Vec3> places;
    for (const BoundaryInterval& border : borders) {
        const SurfaceCurve curve = curves.curve(border);
        for (int k = 0; k <= steps; ++k) places.push_back(curve.at(double(k) / steps).position);
    }
    return places;
}

double polyline_length(const BoundaryCurves& curves, const EdgeSide& run, int steps) {
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

} // namespace keiko
