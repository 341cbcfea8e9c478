#include "keiko/workflow/band_picture.h"

#include "keiko/base/units.h"
#include "keiko/inspect/basics/line_field.h"
#include "keiko/light/rig/rig_areas.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double zebra_period = 10, isophote_period = 5; ///< degrees, a dark and a light band

double angle_to_vertical(const Vec3& direction) {
    return radians_to_degrees(
        std::atan2(std::hypot(direction.x, direction.y), direction.z)); // exact near the poles too
}

/// Phase in bands: bands of one kind have an integer part that is 2n.
double phase_of(AnalysisMode look, const Seen& seen, std::span<const LineField> planes) {
    if (look == AnalysisMode::zebra)
        return 2 * angle_to_vertical(seen.ray + seen.normal * (2 * seen.facing())) / zebra_period;
    if (look == AnalysisMode::isophote) return 2 * angle_to_vertical(seen.normal) / isophote_period;
    for (const LineField& plane : planes) {
        const LineField::Image image = plane.image(seen.place, seen.normal);
        const CPlaneFrame& frame = plane.plane();
        if (image.faces && frame.pitch > 0)
            return 2 * (image.value - frame.first) / frame.pitch + 0.5;
    }
    return none;
}

/// Share of light bands between two phases: the integral of a square wave.
double light_share(double from, double to) {
    const auto light_up_to = [](double phase) {
        const double whole = std::floor(phase / 2);
        return whole + std::clamp(phase - 2 * whole - 1, 0.0, 1.0);
    };
    return (light_up_to(to) - light_up_to(from)) / (to - from);
}

/// Light from 0, dark, to 1; grey if there is no phase.
double light_of(const PixelValues& phases, int x, int y) {
    const double phase = phases.at(x, y);
    if (std::isnan(phase)) return 0.5;
    const double sharpest = std::max(1e-6, 1e-12 * std::abs(phase));
    const double reach = std::max(sharpest, phases.reach(x, y));
    return light_share(phase - reach, phase + reach);
}

/// Area lights that the normals of a surface meet: the highlights of lights without a pitch.
class MetLights {
public:
    MetLights(const LightRig& rig, const FilmSight& sight) : areas_(rig), sight_(sight) {}

    bool empty() const { return areas_.empty(); }
    /// Share of a pixel whose normals meet a light, 0 to 1.
    double share(int x, int y, const Seen& seen) const {
        const Change across = change(x, y, 1, 0, seen), up = change(x, y, 0, 1, seen);
        const RayDifferentials spread{.origin_dx = across.place,
                                      .origin_dy = up.place,
                                      .direction_dx = across.normal,
                                      .direction_dy = up.normal};
        double left = 1;
        for (const RigAreas::Layer& layer :
             areas_.along(seen.place, seen.normal, spread, std::numeric_limits<double>::infinity()))
            left *= 1 - layer.hit.coverage;
        return 1 - left;
    }

private:
    struct Change {
        Vec3 place{0}, normal{0}; ///< per pixel
    };
    /// Change to the next pixel on the same face, or from the last; none beside others.
    Change change(int x, int y, int dx, int dy, const Seen& seen) const {
        for (const int way : {1, -1}) {
            const int i = x + way * dx, k = y + way * dy;
            if (i < 0 || k < 0 || i >= sight_.width() || k >= sight_.height()) continue;
            if (sight_.face(i, k) != sight_.face(x, y)) continue;
            if (const auto other = sight_.at(i, k))
                return {(other->place - seen.place) * way, (other->normal - seen.normal) * way};
        }
        return {};
    }

    RigAreas areas_;
    const FilmSight& sight_;
};

std::string band_words(AnalysisMode look, bool has_areas) {
    if (look == AnalysisMode::zebra) return "zebra: mirrored rings of 5 degrees about the vertical";
    if (look == AnalysisMode::isophote) return "isophotes: bands of 2.5 degrees from the vertical";
    if (has_areas) return "highlights: normals that meet lamps, or the plane of a row, by pitch";
    return "highlight lines: normals that meet the lamps' plane, by pitch";
}

std::vector<LineField> planes_of(const LightRig& rig, const Camera& camera) {
    std::vector<LineField> planes;
    for (const LightSource& source : rig.sources)
        if (const auto* plane = std::get_if<CPlane>(&source))
            planes.emplace_back(LineLook::highlight, LineEye(camera), *plane, Vec3(0));
    return planes;
}

} // namespace

Image band_picture(AnalysisMode look, const FilmSight& sight, const Camera& camera,
                   const LightRig& rig) {
    constexpr double dark = 0.06, light = 0.94;
    const std::vector<LineField> planes = planes_of(rig, camera);
    const PixelValues phases(sight, [&](int x, int y) {
        const auto seen = sight.at(x, y);
        return seen ? phase_of(look, *seen, planes) : none;
    });
    const MetLights met(look == AnalysisMode::highlight ? rig : LightRig(), sight);
    const auto light_at = [&](int x, int y, const Seen& seen) {
        if (met.empty()) return light_of(phases, x, y);
        const double of_rows = std::isnan(phases.at(x, y)) ? 0 : light_of(phases, x, y);
        return std::max(of_rows, met.share(x, y, seen));
    };
    return with_caption(shaded_picture(sight,
                                       [&](int x, int y, const Seen& seen) {
                                           return Rgb(dark + (light - dark) * light_at(x, y, seen));
                                       }),
                        band_words(look, !met.empty()));
}

} // namespace keiko
