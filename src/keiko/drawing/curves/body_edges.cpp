#include "keiko/drawing/curves/body_edges.h"

#include "keiko/base/parallel.h"
#include "keiko/drawing/curves/curve_samples.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/seams/seam_probe.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <tuple>

namespace keiko {
namespace {

constexpr int probes = 8; ///< of a seam, between its ends

PlacedFace face_of(const BoundaryInterval& interval) {
    return {interval.instance, interval.face};
}

/// The sharpest angle of a seam in degrees, and its widest gap in mm, at places along it.
struct SeamForm {
    double angle = 0, gap = 0;
};

SeamForm form_of(const BoundaryCurves& borders, const Seam& seam) {
    const SeamProbe probe(borders, seam);
    SeamForm form;
    for (int i = 0; i < probes; ++i) {
        const double share = (i + 0.5) / probes;
        const SeamPoint point = probe.at(probe.begin() + share * (probe.end() - probe.begin()));
        form.angle = std::max(form.angle, point.angle.value_or(0));
        form.gap = std::max(form.gap, point.gap);
    }
    return form;
}

/// The directions into both faces at a place of their seam; 0 where unknown.
std::array<Vec3, 2> inward_sides(const std::optional<BoundaryFrame>& a,
                                 const std::optional<BoundaryFrame>& b) {
    return {a ? a->inward : Vec3(0), b ? b->inward : Vec3(0)};
}

/// The parts of borders that seams take up.
class TakenBorders {
public:
    explicit TakenBorders(const std::vector<Seam>& seams) {
        for (const Seam& seam : seams)
            for (const BoundaryInterval& side : {seam.a, seam.b}) {
                const auto [low, high] = std::minmax(side.begin, side.end);
                taken_[key(side)].emplace_back(low, high);
            }
        for (auto& [border, parts] : taken_) std::sort(parts.begin(), parts.end());
    }

    /// The parts of a whole border that are left.
    std::vector<ParameterInterval> left(const BoundaryInterval& border) const {
        std::vector<ParameterInterval> parts;
        double from = 0;
        const auto found = taken_.find(key(border));
        if (found != taken_.end())
            for (const auto& [low, high] : found->second) {
                if (low - from > least) parts.push_back({from, low});
                from = std::max(from, high);
            }
        if (1 - from > least) parts.push_back({from, 1});
        return parts;
    }

private:
    static constexpr double least = 1e-6; ///< of a border's parameters
    using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;
    static Key key(const BoundaryInterval& b) { return {b.instance, b.face, b.curve}; }

    std::map<Key, std::vector<std::pair<double, double>>> taken_;
};

CurveCourse course_of(const SurfaceCurve& curve, CurveSamples samples) {
    return {std::move(samples.points),
            [curve, t = std::move(samples.t)](std::size_t i, double share) {
                return curve.at(t[i] + share * (t[i + 1] - t[i])).position;
            }};
}

/// mm: sides collapsed into a point, as at poles, are shorter.
constexpr double shortest_edge = 1e-4;

} // namespace

BodyEdges::BodyEdges(const SurfaceModel& model, const BodyEdgeOptions& options, const Job& job)
    : model_(model), options_(options), borders_(model), creases_(model) {
    const std::vector<Seam> seams = pair_seams(model, options.join, job);
    add_seams(seams, job);
    add_free_edges(seams);
    add_creases_inside();
    add_occluding(job);
}

ModelCurve BodyEdges::curve_of(CurveKind kind, const SurfaceCurve& curve,
                               const ParameterInterval& part, const Sides& sides) const {
    CurveSamples samples = sampled(curve, part.begin, part.end, options_.chord_error);
    ModelCurve made{kind};
    if (sides)
        made.sides = [sides, t = samples.t](std::size_t i, double share) {
            return sides(t[i] + share * (t[i + 1] - t[i]));
        };
    made.course = course_of(curve, std::move(samples));
    return made;
}

BodyEdges::Sides BodyEdges::sides_of(const Seam& seam) const {
    return [probe = SeamProbe(borders_, seam), a = borders_.curve(seam.a),
            b = borders_.curve(seam.b)](double t) {
        const SeamPoint point = probe.at(t);
        return inward_sides(a.frame(t), b.frame(point.s));
    };
}

BodyEdges::Sides BodyEdges::sides_of(const CreaseLine& line) const {
    return [this, &line, curve = creases_.curve(line)](double t) {
        const auto frame = curve.frame(t);
        const auto beyond = creases_.inward_beyond(line, t);
        return std::array{frame ? frame->inward : Vec3(0), beyond.value_or(Vec3(0))};
    };
}

void BodyEdges::add_seams(const std::vector<Seam>& seams, const Job& job) {
    std::vector<ModelCurve> found(seams.size());
    parallel_for(seams.size(), job, "edges", [&](std::size_t i) {
        const Seam& seam = seams[i];
        const SeamForm form = form_of(borders_, seam);
        const bool is_crease = form.angle > options_.crease_angle;
        if (!is_crease && face_of(seam.a) == face_of(seam.b)) return;
        found[i] = curve_of(is_crease ? CurveKind::crease : CurveKind::seam, borders_.curve(seam.a),
                            {seam.a.begin, seam.a.end}, is_crease ? sides_of(seam) : Sides());
        found[i].faces = {face_of(seam.a), face_of(seam.b)};
        found[i].reach = 2 * form.gap;
    });
    for (ModelCurve& curve : found)
        if (curve.course.length() > shortest_edge) curves_.push_back(std::move(curve));
}

void BodyEdges::add_free_edges(const std::vector<Seam>& seams) {
    const TakenBorders taken(seams);
    for (const BoundaryInterval& border : borders_.all()) {
        const std::vector<ParameterInterval> parts = taken.left(border);
        const bool whole = parts.size() == 1 && parts[0].begin == 0 && parts[0].end == 1;
        // What seams leave over at their ends, where corners do not meet, is no free edge.
        const double shortest = whole ? shortest_edge : std::max(shortest_edge, options_.join);
        for (const ParameterInterval& part : parts) {
            ModelCurve curve = curve_of(CurveKind::edge, borders_.curve(border), part, {});
            curve.faces = {face_of(border)};
            if (curve.course.length() > shortest) curves_.push_back(std::move(curve));
        }
    }
}

std::vector<ParameterInterval> BodyEdges::material_parts(const CreaseLine& line) const {
    const TrimRegion trims(model_, model_.faces[line.face]);
    if (trims.untrimmed()) return {{0, 1}};
    const Vec2 a(line.p_curve[0].x, line.p_curve[0].y), b(line.p_curve[1].x, line.p_curve[1].y);
    const unsigned fixed = a.x == b.x ? 0 : 1, along = 1 - fixed;
    std::vector<double> stops{0};
    for (const double at : trims.crossings(fixed, a[fixed]))
        if (const double t = (at - a[along]) / (b[along] - a[along]); t > 0 && t < 1)
            stops.push_back(t);
    stops.push_back(1);
    std::sort(stops.begin(), stops.end());
    std::vector<ParameterInterval> parts;
    for (std::size_t i = 1; i < stops.size(); ++i)
        if (trims.contains(a + (b - a) * ((stops[i - 1] + stops[i]) / 2)))
            parts.push_back({stops[i - 1], stops[i]});
    return parts;
}

bool BodyEdges::is_sharp(const CreaseLine& line) const {
    const Sides sides = sides_of(line);
    for (int i = 0; i < probes; ++i) {
        const auto [a, b] = sides((i + 0.5) / probes);
        const bool known = a.length2() > 0 && b.length2() > 0;
        if (known && angle_between(a, -b) * 180 / std::numbers::pi > options_.crease_angle)
            return true;
    }
    return false;
}

void BodyEdges::add_creases_inside() {
    for (const CreaseLine& line : creases_.all()) {
        const SurfaceCurve curve = creases_.curve(line);
        const PlacedFace face{line.instance, line.face};
        const Vec3 &a = line.p_curve[0], &b = line.p_curve[1];
        const bool first_side = std::tie(a.x, a.y) < std::tie(b.x, b.y); // either side has the line
        const bool drawn = first_side && is_sharp(line);
        for (const ParameterInterval& part : material_parts(line)) {
            occluding_.push_back(occluding_along(curve, face, part));
            if (!drawn) continue;
            curves_.push_back(curve_of(CurveKind::crease, curve, part, sides_of(line)));
            curves_.back().faces = {face};
        }
    }
}

OccludingCurve BodyEdges::occluding_along(const SurfaceCurve& curve, const PlacedFace& face,
                                          const ParameterInterval& part) const {
    CurveSamples samples = sampled(curve, part.begin, part.end, options_.chord_error);
    OccludingCurve made{face, 1, {}, {}};
    made.inward = [curve, t = samples.t](std::size_t i, double share) {
        const auto frame = curve.frame(t[i] + share * (t[i + 1] - t[i]));
        return frame ? frame->inward : Vec3(0);
    };
    made.course = course_of(curve, std::move(samples));
    return made;
}

void BodyEdges::add_occluding(const Job& job) {
    const std::vector<BoundaryInterval> all = borders_.all();
    std::vector<OccludingCurve> found(all.size());
    parallel_for(all.size(), job, "edges", [&](std::size_t i) {
        found[i] = occluding_along(borders_.curve(all[i]), face_of(all[i]), {0, 1});
    });
    for (OccludingCurve& curve : found)
        if (curve.course.length() > shortest_edge) occluding_.push_back(std::move(curve));
}

} // namespace keiko
