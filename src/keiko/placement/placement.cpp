#include "keiko/placement/placement.h"

#include "keiko/math/disjoint_sets.h"
#include "keiko/placement/plane_frame.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace keiko {

namespace {

struct Spacing {
    double pixels = 0, weight = 0;
};

/// Spacing of stripes where a sample reflects the lamps; nullopt if it does not.
std::optional<double> spacing_at(const ViewSample& sample, const CPlane& plane) {
    const auto hit = meet(frame_of(plane), sample.mirror);
    const Box2 lamps{Vec2(0), Vec2(plane.u.length(), plane.v.length())};
    if (!hit || hit->cosine < grazing_cosine || !lamps.contains(hit->place) || !hit->gradients)
        return {};
    const double gradient = hit->gradients->v.length();
    if (!(gradient > 0) || !std::isfinite(gradient)) return {};
    return plane.spacing() / gradient;
}

std::vector<Spacing> spacings(std::span<const ViewSample> samples, std::span<const CPlane> planes) {
    std::vector<Spacing> found;
    for (const ViewSample& sample : samples) {
        if (sample.blocked) continue;
        for (const CPlane& plane : planes)
            if (const auto pixels = spacing_at(sample, plane)) {
                found.push_back({*pixels, sample.weight});
                break;
            }
    }
    std::sort(found.begin(), found.end(),
              [](const Spacing& a, const Spacing& b) { return a.pixels < b.pixels; });
    return found;
}

/// The spacing below which `share` of the weight lies, from sorted spacings.
double quantile(std::span<const Spacing> sorted, double total, double share) {
    double sum = 0;
    for (const Spacing& s : sorted)
        if ((sum += s.weight) >= share * total) return s.pixels;
    return 0;
}

} // namespace

StripeStatistics stripe_statistics(std::span<const ViewSample> samples,
                                   std::span<const CPlane> planes, const StripeSpacing& wanted) {
    const std::vector<Spacing> sorted = spacings(samples, planes);
    double total = 0, in_range = 0, log_sum = 0, log_squares = 0;
    for (const Spacing& s : sorted) {
        const double log_spacing = std::log(s.pixels);
        total += s.weight;
        log_sum += s.weight * log_spacing;
        log_squares += s.weight * log_spacing * log_spacing;
        if (wanted.least <= s.pixels && s.pixels <= wanted.most) in_range += s.weight;
    }
    if (!(total > 0)) return {};
    const double mean = log_sum / total;
    return {.narrow = quantile(sorted, total, 0.1),
            .median = quantile(sorted, total, 0.5),
            .wide = quantile(sorted, total, 0.9),
            .in_range = in_range / total,
            .uniformity = std::exp(-std::sqrt(std::max(0.0, log_squares / total - mean * mean)))};
}

namespace {

UnreachedBecause reason(const LampField& field, std::size_t i) {
    if (field.samples()[i].blocked) return UnreachedBecause::blocked;
    return field.hidden(i) ? UnreachedBecause::hidden : UnreachedBecause::beyond_lamps;
}

/// Joins samples that are neighbours in their picture and unreached for the same reason.
DisjointSets joined(const LampField& field) {
    using Cell = std::tuple<std::uint32_t, int, int>;
    DisjointSets groups(field.samples().size());
    std::map<Cell, std::size_t> cells;
    for (std::size_t i = 0; i < field.samples().size(); ++i) {
        if (field.reached(i)) continue;
        const ViewSample& s = field.samples()[i];
        const int x = static_cast<int>(s.pixel.x / s.edge),
                  y = static_cast<int>(s.pixel.y / s.edge);
        for (const Cell& before : {Cell{s.view, x - 1, y}, Cell{s.view, x, y - 1}})
            if (const auto found = cells.find(before);
                found != cells.end() && reason(field, found->second) == reason(field, i))
                groups.join(found->second, i);
        cells.emplace(Cell{s.view, x, y}, i);
    }
    return groups;
}

UnreachedRegion region_of(const LampField& field, const std::vector<std::size_t>& members) {
    const std::span<const ViewSample> samples = field.samples();
    UnreachedRegion region;
    region.view = samples[members.front()].view;
    region.because = reason(field, members.front());
    std::set<std::uint32_t> faces;
    Vec2 middle(0);
    double weight = 0;
    for (const std::size_t i : members) {
        const ViewSample& s = samples[i];
        weight += s.weight;
        middle += s.pixel * s.weight;
        region.box.extend(s.position());
        region.pixels.extend(s.pixel);
        faces.insert(s.face);
    }
    middle /= weight;
    const std::size_t nearest =
        *std::min_element(members.begin(), members.end(), [&](std::size_t a, std::size_t b) {
            return (samples[a].pixel - middle).length2() < (samples[b].pixel - middle).length2();
        });
    region.place = samples[nearest].position();
    region.faces.assign(faces.begin(), faces.end());
    region.share = weight / field.total_weight();
    return region;
}

} // namespace

std::string_view name_of(UnreachedBecause reason) {
    switch (reason) {
        case UnreachedBecause::blocked:
            return "mirrors the body";
        case UnreachedBecause::hidden:
            return "hidden by lamps";
        default:
            return "beyond the lamps";
    }
}

std::vector<UnreachedRegion> unreached_regions(const LampField& field, double least_share) {
    DisjointSets groups = joined(field);
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < field.samples().size(); ++i)
        if (!field.reached(i)) members[groups.root(i)].push_back(i);
    std::vector<UnreachedRegion> regions;
    for (const auto& [first, all] : members) {
        UnreachedRegion region = region_of(field, all);
        if (region.share >= least_share) regions.push_back(std::move(region));
    }
    std::stable_sort(regions.begin(), regions.end(),
                     [](const auto& a, const auto& b) { return a.share > b.share; });
    return regions;
}

namespace {

constexpr int histogram_cells = 128;
constexpr double worth_a_warning = 0.05; ///< unreached share of the picture's weight on one face
constexpr double histogram_margin = 0.1; ///< of the lamps' rectangle, shown around it

std::vector<FaceCoverage> face_coverage(const LampField& field) {
    std::vector<FaceCoverage> faces(field.region_count());
    for (std::size_t i = 0; i < field.samples().size(); ++i) {
        const ViewSample& s = field.samples()[i];
        FaceCoverage& face = faces[field.region(i)];
        face.instance = s.instance;
        face.face = s.face;
        face.share += s.weight;
        if (field.reached(i)) face.reached += s.weight;
    }
    for (FaceCoverage& face : faces) {
        face.reached /= face.share;
        face.share /= field.total_weight();
    }
    std::stable_sort(faces.begin(), faces.end(), [](const FaceCoverage& a, const FaceCoverage& b) {
        return a.share * (1 - a.reached) > b.share * (1 - b.reached);
    });
    return faces;
}

Diagnostics warnings(const SurfaceModel& model, std::span<const FaceCoverage> faces) {
    const auto percent = [](double share) {
        return std::to_string(std::lround(share * 100)) + " %";
    };
    Diagnostics found;
    for (const FaceCoverage& face : faces)
        if (face.share * (1 - face.reached) > worth_a_warning)
            found.push_back({Severity::warning, model.describe(model.faces[face.face]),
                             "lamps reach only " + percent(face.reached) + " of it, it is " +
                                 percent(face.share) + " of what is seen"});
    return found;
}

double blocked_share(const LampField& field) {
    double sum = 0;
    for (const ViewSample& s : field.samples())
        if (s.blocked) sum += s.weight;
    return sum / field.total_weight();
}

} // namespace

HitHistogram hit_histogram(const LampField& field, const CPlane& plane) {
    const PlaneFrame frame = frame_of(plane);
    std::vector<WeightedPlace> places;
    for (const ViewSample& s : field.samples())
        if (const auto hit = meet(frame, s.mirror);
            !s.blocked && hit && hit->cosine >= grazing_cosine)
            places.push_back({hit->place, s.weight});
    const Vec2 size(plane.u.length(), plane.v.length());
    const Vec2 margin = size * histogram_margin;
    return HitHistogram(places, histogram_cells, {-margin, size + margin}).smoothed();
}

void tell_what_is_reached(Placement& placement, const LampField& field, const SurfaceModel& model,
                          const StripeSpacing& wanted) {
    std::vector<CPlane> planes;
    for (const PlacedPlane& plane : placement.planes) planes.push_back(plane.lamps);
    placement.coverage = field.coverage();
    placement.stripes = stripe_statistics(field.samples(), planes, wanted);
    placement.faces = face_coverage(field);
    placement.unreached = unreached_regions(field);
    placement.diagnostics = warnings(model, placement.faces);
    placement.blocked = blocked_share(field);
}

} // namespace keiko
