#include "keiko/inspect/structure/edge_runs.h"
#include "keiko/inspect/structure/face_structure.h"

#include <algorithm>

namespace keiko {
namespace {

MeasuredValue measured(const BoundaryCurves& curves, const EdgeSide& run, double limit) {
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
    for (const EdgeSide& run : edge_runs(borders)) {
        job.check();
        const FaceKey face{run.face.instance, run.face.face};
        const auto found = shortest.find(face);
        constexpr int few = 2;
        const double least = polyline_length(borders.curves, run, few);
        if (found != shortest.end() && least >= std::max(limit, found->second.value)) continue;
        const MeasuredValue value = measured(borders.curves, run, limit);
        if (run.curves.front().curve >= natural_side && value.value < side_point) continue;
        if (found == shortest.end())
            shortest.emplace(face, value);
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
