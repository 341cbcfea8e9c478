#include "keiko/placement/placement.h"

#include "keiko/placement/plane_frame.h"

#include <algorithm>
#include <cmath>

namespace keiko {
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
