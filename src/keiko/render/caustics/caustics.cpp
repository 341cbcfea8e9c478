#include "keiko/render/caustics/caustics.h"

#include "keiko/light/luminance/photometry.h"
#include "keiko/render/caustics/beam_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Room about a beam, as a share of its size, within which rays are sought: for the bend of its
/// sides, and for folds next to it.
constexpr double margin = 0.3;
/// How much less area rays have than on the first surface from which on they meet in a focus. Their
/// places are known too badly to count them; the sun's own disc allows no more than 5e4.
constexpr double focused = 2e5;

std::vector<Box3> boxes_of(std::span<const Beam> beams) {
    std::vector<Box3> boxes;
    boxes.reserve(beams.size());
    for (const Beam& beam : beams) {
        Box3 box;
        for (const Vec3& corner : beam.corners) box.extend(corner);
        boxes.push_back(box.padded(margin * box.size()));
    }
    return boxes;
}

std::vector<bool> all_but(std::vector<bool> faces) {
    faces.flip();
    return faces;
}

} // namespace

/// A ray that lands at a place.
struct Caustics::Root {
    Vec2 at;
    Rgb perpendicular; ///< lx on a surface across the light
    Vec3 direction;    ///< of the light
    double reach;      ///< of the coordinates, within which another root is the same
    bool in_focus;     ///< true where the light has no limit
};

Caustics::Caustics(const Tracer& tracer, std::span<const Material> materials,
                   const PreparedRig& rig, const CausticSpec& spec, const Job& job)
    : paths_(tracer, materials, rig.medium, spec),
      sources_(rig.sources.size()),
      tree_(std::vector<Box3>()) {
    const std::vector<bool> casting = casting_faces(materials, spec.min_weight);
    if (std::find(casting.begin(), casting.end(), true) == casting.end()) return;
    const Tracer casters = tracer.without(all_but(casting));
    Box3 around;
    for (const Box3& box : casters.boxes()) around.extend(box);
    size_ = around.size();
    const Box3 scene = tracer.bounds();
    for (std::size_t source = 0; source < sources_; ++source)
        add(source, rig.sources[source], casters.boxes(), scene, spec, job);
    tree_ = BoxTree(boxes_of(beams_));
}

void Caustics::add(std::size_t source, const PreparedSource& light, std::span<const Box3> boxes,
                   const Box3& scene, const CausticSpec& spec, const Job& job) {
    for (const LightChart& chart : charts_of(light, boxes, scene)) {
        const std::vector<Beam> beams = beams_of(chart, paths_, spec, job);
        beams_.insert(beams_.end(), beams.begin(), beams.end());
        chart_of_beam_.resize(beams_.size(), static_cast<std::uint32_t>(charts_.size()));
        charts_.push_back(chart);
        source_of_chart_.push_back(source);
    }
}

std::vector<std::uint32_t> Caustics::beams_at(const SurfaceFootprint& place) const {
    Box3 box;
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) box.extend(place.position + place.dx * x + place.dy * y);
    // A curved surface leaves its tangent plane.
    std::vector<std::uint32_t> found = tree_.overlapping(box.padded(box.size() / 4));
    std::erase_if(found, [&](std::uint32_t i) {
        const Beam& beam = beams_[i];
        return beam.face != place.face || beam.instance != place.instance ||
               !(beam.normal.dot(place.normal) > 0);
    });
    return found;
}

CausticLight Caustics::over(const SurfaceFootprint& footprint, const ClearCoat* coat) const {
    CausticLight light;
    const double area = metres(metres(footprint.dx.cross(footprint.dy).length()));
    if (!(area > 0)) return light;
    for (const std::uint32_t i : beams_at(footprint)) {
        const Beam& beam = beams_[i];
        const Rgb lx = beam.flux * (share_within(beam, footprint) / area);
        const double cosine = std::abs(beam.normal.dot(beam.direction));
        light.incident += lx;
        light.entering += coat ? lx * coat->entering(cosine) : lx;
    }
    return light;
}

std::optional<Caustics::Root> Caustics::root_near(std::uint32_t number, const Vec3& place) const {
    constexpr int most_steps = 40;
    constexpr double longest = 4; // steps of Newton's, in sizes of the beam
    const Beam& beam = beams_[number];
    const LightChart& chart = chart_of(number);
    const double size =
        std::max((beam.at[1] - beam.at[0]).length(), (beam.at[2] - beam.at[0]).length());
    constexpr double same = 1e-4, exact = 1e-9; // of the beam: roots that near are one, and final
    constexpr double rounding = 1e-11;          // of landings, in sizes of all that casts
    constexpr int most_refinements = 4;         // rounding may keep Newton's steps from ending
    const double met = 1e-8 * size_;            // mm
    Vec2 at = (beam.at[0] + beam.at[1] + beam.at[2]) / 3;
    const Vec2 begin = at;
    std::optional<Root> found;
    int landed = 0;
    for (int step = 0; step < most_steps; ++step) {
        const std::optional<LightLanding> landing = paths_.landing(chart, at, beam.way);
        if (!landing) return found;
        const Vec3 off = place - landing->position;
        const Vec3 across = landing->dx.cross(landing->dy);
        const double area2 = across.length2();
        if (!(area2 > 0)) return found;
        Vec2 by(off.cross(landing->dy).dot(across) / area2,
                landing->dx.cross(off).dot(across) / area2);
        if (off.length() < met) {
            if (!chart.reaches(landing->first)) return {};
            const double cosine = landing->normal.dot(-landing->direction);
            const double area = std::sqrt(area2);
            const bool in_focus = chart.spread(landing->first) > focused * area;
            const Rgb flux = chart.flux(at) * landing->weight;
            const double most = std::max(landing->dx.length(), landing->dy.length());
            const double reach = std::max(same * size, rounding * size_ * most / area);
            found = Root{at, flux / (metres(metres(area)) * cosine), landing->direction, reach,
                         in_focus};
            // Beside a focal line rays from far apart land as near.
            if (in_focus || by.length() < exact * size || ++landed > most_refinements) return found;
        }
        if (by.length() > size) by *= size / by.length();
        at += by;
        if (!((at - begin).length() < longest * size)) return found;
    }
    return found;
}

std::vector<Rgb> Caustics::at(const SurfaceFootprint& place) const {
    std::vector<Rgb> lx(sources_);
    struct Found {
        Root root;
        LightWay way;
        std::uint32_t chart;
    };
    std::vector<Found> found;
    for (const std::uint32_t beam : beams_at(place)) {
        const std::optional<Root> root = root_near(beam, place.position);
        if (!root) continue;
        const std::uint32_t chart = chart_of_beam_[beam];
        const LightWay way = beams_[beam].way;
        const bool known = std::any_of(found.begin(), found.end(), [&](const Found& other) {
            return other.chart == chart && other.way == way &&
                   (other.root.at - root->at).length() < std::max(other.root.reach, root->reach);
        });
        if (known) continue;
        found.push_back({*root, way, chart});
        const double cosine = -root->direction.dot(place.normal);
        if (!(cosine > 0)) continue;
        constexpr double infinity = std::numeric_limits<double>::infinity();
        lx[source_of_chart_[chart]] +=
            root->in_focus ? Rgb(infinity) : root->perpendicular * cosine;
    }
    return lx;
}

Rgb Caustics::flux_on(std::uint32_t face) const {
    Rgb sum;
    for (const Beam& beam : beams_)
        if (beam.face == face) sum += beam.flux;
    return sum;
}

} // namespace keiko
