#include "tests/support/light_trial.h"

#include "keiko/film/tone_mapping.h"
#include "keiko/inspect/lines/joined_lines.h"
#include "keiko/placement/place_lamps.h"
#include "keiko/render/shading/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko::test {
namespace {

constexpr double visible = 0.02;
constexpr int window = 5; ///< px

Tracer tracer_of(SurfaceModel model) {
    TracerOptions options;
    options.second_derivatives = true;
    return Tracer(std::move(model), options);
}

Vec3 center_of(const CPlane& plane) {
    return plane.origin + plane.u * 0.5 + plane.v * 0.5;
}

/// Display value of a luminance.
double shown(const Film& film, int x, int y, double white) {
    const float* c = film.color.pixel(x, y);
    return srgb_oetf(luminance(Rgb(c[0], c[1], c[2])) / white);
}

/// Whether some window of a part of the pictures differs visibly.
bool differs(const Film& a, const Film& b, double white, const Box2& part) {
    const auto pixel = [](double value, int most) {
        return std::clamp(static_cast<int>(value), 0, most);
    };
    const int right = pixel(part.upper.x, a.color.width - window);
    const int bottom = pixel(part.upper.y, a.color.height - window);
    for (int y = pixel(part.lower.y, bottom); y <= bottom; ++y)
        for (int x = pixel(part.lower.x, right); x <= right; ++x) {
            double sum = 0;
            for (int j = y; j < y + window; ++j)
                for (int i = x; i < x + window; ++i)
                    sum += shown(a, i, j, white) - shown(b, i, j, white);
            if (std::abs(sum) >= visible * window * window) return true;
        }
    return false;
}

Box2 around(const Camera& camera, const Vec3& place) {
    constexpr double reach = 50; // mm
    Box2 box;
    for (const double dx : {-reach, reach})
        for (const double dy : {-reach, reach})
            if (const auto at = project(camera, place + Vec3(dx, dy, 0))) box.extend(*at);
    return box;
}

} // namespace

const char* name_of(TrialLight light) {
    return light == TrialLight::point      ? "point light"
           : light == TrialLight::parallel ? "parallel light"
                                           : "twelve tubes";
}

LightTrial::LightTrial(Material paint, int height) : paint_(std::move(paint)) {
    camera_.eye = Vec3(-1500, -600, 1300);
    camera_.target = Vec3(-60, -20, -40);
    camera_.vertical_fov = 28;
    camera_.height = height;
    camera_.width = height * 3 / 2;
    const SurfaceModel clean = defect_panel(Defect::dent, 0);
    PlacementOptions options;
    options.planes = 1;
    LightRig& tubes = rigs_[std::size_t(TrialLight::tubes)];
    tubes = place_lamps(tracer_of(clean), clean, camera_, options).rig;
    const Vec3 middle = center_of(std::get<CPlane>(tubes.sources.front()));
    Spotlight lamp;
    lamp.position = middle;
    lamp.aim = Vec3(0);
    lamp.half_angle = 90;
    lamp.profile = EdgeProfile{BeamEdge::sharp};
    lamp.intensity = Rgb(1e4);
    rigs_[std::size_t(TrialLight::point)].sources.emplace_back(lamp);
    Sun sun;
    sun.direction = -middle;
    rigs_[std::size_t(TrialLight::parallel)].sources.emplace_back(sun);
    for (const TrialLight light : trial_lights)
        clean_[std::size_t(light)] = picture(light, Defect::dent, 0);
}

Film LightTrial::picture(TrialLight light, Defect defect, double size) const {
    const Tracer tracer = tracer_of(defect_panel(defect, size));
    const std::vector<Material> paints(2, paint_);
    const PictureScene scene{tracer, paints, rigs_[std::size_t(light)]};
    return render(scene, camera_, {});
}

int LightTrial::seen(TrialLight light, Defect defect, double size) const {
    const Film& clean = clean_[std::size_t(light)];
    const Film film = picture(light, defect, size);
    const double white = white_luminance(clean);
    int count = 0;
    for (const Vec3& place : places_of(defect))
        count += differs(film, clean, white, around(camera_, place));
    return count;
}

LightTrial::Threshold LightTrial::threshold(TrialLight light, Defect defect, double least,
                                            double most, double step) const {
    const auto smallest = [&](int places) {
        if (seen(light, defect, most) < places) return std::numeric_limits<double>::infinity();
        double low = least, high = most;
        while (high > low * step) {
            const double middle = std::sqrt(low * high);
            (seen(light, defect, middle) >= places ? high : low) = middle;
        }
        return high;
    };
    return {smallest(1), smallest(9)};
}

std::vector<LineCrossing> LightTrial::crossings(Defect defect, double size) const {
    const SurfaceModel model = defect_panel(defect, size);
    const std::array sources{
        LineSource(std::get<CPlane>(rigs_[std::size_t(TrialLight::tubes)].sources.front()))};
    const Job job;
    JoinedLines lines =
        join_lines(model, LineSeams(model, 0.5, job),
                   surface_lines(model, tracer_of(model), sources, camera_, {}, job), sources,
                   camera_, LineLook::reflection, CriteriaPreset{}, job);
    constexpr double at_seam = 0.01; // mm
    std::erase_if(lines.crossings,
                  [](const LineCrossing& c) { return std::abs(c.place.x) > at_seam; });
    return std::move(lines.crossings);
}

} // namespace keiko::test
