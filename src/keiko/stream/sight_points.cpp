#include "keiko/stream/sight_points.h"

#include "keiko/light/fog/transmittance.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/light/rig/luminance_along.h"
#include "keiko/light/sky/sky_scattering.h"
#include "keiko/light/spotlight/point_light.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/stream/hit_columns.h"
#include "keiko/stream/source_columns.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// The eyes of some lines.
struct Piece : RowPiece {
    std::size_t eyes = 0;
};

void append_field(std::string& row, double number) {
    if (std::isinf(number))
        row += number < 0 ? "-inf" : "inf";
    else if (!std::isnan(number))
        append_number(row, number);
    row += ',';
}

constexpr double mm_per_metre = 1000;

/// A scene with its fog, prepared once for all eyes.
class Lookout {
public:
    Lookout(const Scene& scene, const SightLimits& limits, const Job& job)
        : scene_(scene),
          limits_(limits),
          rig_(*scene.rig),
          medium_(*rig_.medium),
          picture_(scene.picture(rig_)),
          options_(picture_options(scene)),
          integrator_(picture_, options_, std::nullopt, job) {}

    std::string header() const {
        std::string text = "distance_m,near_contrast,contrast,visible_to_m";
        for (std::size_t i = 0; i < rig_.signs.size(); ++i) {
            const std::string name = ",sign." + std::to_string(i);
            text += name + ".contrast" + name + ".legible_to_m";
        }
        const std::vector<std::string> names = source_columns(rig_);
        for (std::size_t i = 0; i < names.size(); ++i)
            if (is_bare(rig_.sources[i]))
                text += "," + names[i] + ".lux," + names[i] + ".visible_to_m";
        return text + "\n";
    }

    /// The rows of some eyes.
    std::string rows(std::span<const Ray> eyes) const {
        const auto hits = scene_.seen().first_hits(eyes);
        const std::vector<double> near = near_luminances(eyes, hits);
        std::string text;
        for (std::size_t i = 0; i < eyes.size(); ++i) {
            append_object(text, eyes[i], hits[i], near[i]);
            for (const LuminousSign& sign : rig_.signs) append_sign(text, eyes[i].origin, sign);
            for (const LightSource& source : rig_.sources)
                std::visit([&](const auto& light) { append_lamp(text, eyes[i].origin, light); },
                           source);
            text.back() = '\n';
        }
        return text;
    }

private:
    /// The way of light from a place to the eye.
    struct Way {
        double metres = 0;
        double passed = 0;     ///< share of the light that is left
        double extinction = 0; ///< mean, 1/m
    };

    static bool is_bare(const LightSource& source) {
        return std::visit([]<class Light>(const Light&) { return PointLight<Light>; }, source);
    }

    Way way(const Vec3& eye, const Vec3& place) const {
        const Rgb depth = optical_depth(medium_, {eye, place});
        const double far = metres((place - eye).length());
        const double passed = luminance(transmittance(depth));
        return {far, passed, (passed > 0 ? -std::log(passed) : luminance(depth)) / far};
    }

    /// Luminance of an infinite depth of the fog in a direction, cd/m2: its ambient light, and that
    /// of open skies which it scatters, as if it were as thick everywhere as at the eye.
    double horizon(const Ray& eye) const {
        Medium even = medium_;
        even.extinction = extinction_at(medium_, eye.origin), even.density = HomogeneousDensity{};
        constexpr double depth = 40; // leaves 4e-18
        const double thinnest = std::min({even.extinction.r, even.extinction.g, even.extinction.b});
        Rgb sum = even.ambient;
        if (!(thinnest > 0)) return luminance(sum);
        const Vec3 way = eye.direction.normalized() * (depth / thinnest * mm_per_metre);
        const Segment sight{eye.origin, eye.origin + way};
        for (const LightSource& source : rig_.sources)
            if (const auto* sky = std::get_if<SkyLight>(&source); sky && sky->windows.empty())
                sum +=
                    scattered_light(AttenuatedRay(even, sight), *sky, picture_scattering_tolerance);
        return luminance(sum);
    }

    bool hidden(const Vec3& eye, const Vec3& place) const {
        if (!scene_.occluders) return false;
        Ray sight;
        sight.origin = eye, sight.direction = place - eye;
        sight.t_max = 1;
        return scene_.occluders->tracer().any(sight);
    }

    /// Luminance of surfaces towards the eye, cd/m2, without the fog before them: a step before
    /// each hit there is none. NaN without a hit.
    std::vector<double> near_luminances(std::span<const Ray> eyes, const FirstHits& hits) const {
        constexpr double step = 1; // mm
        std::vector<Ray> close;
        for (std::size_t i = 0; i < eyes.size(); ++i) {
            if (!hits[i]) continue;
            Ray ray = eyes[i];
            const double length = ray.direction.length();
            ray.origin = ray.at(std::max(hits[i]->t - step / length, hits[i]->t / 2));
            close.push_back(ray);
        }
        const SampleBatch view = integrator_.follow(close);
        std::vector<double> found(eyes.size(), std::numeric_limits<double>::quiet_NaN());
        std::size_t next = 0;
        for (std::size_t i = 0; i < eyes.size(); ++i)
            if (hits[i]) found[i] = luminance(view.samples[next++].luminance);
        return found;
    }

    void append_object(std::string& text, const Ray& eye, const Hit* hit, double near) const {
        const double horizon = hit ? this->horizon(eye) : 0;
        if (!(horizon > 0)) {
            if (hit) append_field(text, way(eye.origin, hit->position).metres);
            text += hit ? ",,," : ",,,,";
            return;
        }
        const Way sight = way(eye.origin, hit->position);
        const double contrast = luminance_contrast(near, horizon);
        append_field(text, sight.metres);
        append_field(text, contrast);
        append_field(text, contrast * sight.passed);
        append_field(text, visual_range(contrast, sight.extinction, limits_.contrast));
    }

    void append_sign(std::string& text, const Vec3& eye, const LuminousSign& sign) const {
        const Vec3 center = sign.center();
        if (!sign.panel.shines_at(eye) || hidden(eye, center)) {
            text += "0,0,";
            return;
        }
        const Way sight = way(eye, center);
        const Segment leg{eye, center};
        const VolumetricShadows shafts(rig_, scene_.occluders ? &*scene_.occluders : nullptr,
                                       picture_.casting(), std::span(&leg, 1));
        const double added = luminance(luminance_along(rig_, leg, Rgb(0), shafts.visible()));
        const SignLuminances seen{sign.legend_luminance(), luminance(sign.panel.luminance),
                                  added > 0 ? added / (1 - sight.passed) : 0};
        append_field(text, sign_contrast(seen, sight.passed, added));
        append_field(text, legible_range(seen, sight.extinction, limits_.contrast));
    }

    template <class Light>
    void append_lamp(std::string& text, const Vec3& eye, const Light& light) const {
        if constexpr (PointLight<Light>) {
            const double intensity = luminance(intensity_towards(light, eye));
            if (!(intensity > 0) || hidden(eye, light.position)) {
                text += "0,0,";
                return;
            }
            const Way sight = way(eye, light.position);
            append_field(text, signal_illuminance(intensity, sight.extinction, sight.metres));
            append_field(text, signal_range(intensity, sight.extinction, limits_.lux));
        }
    }

    const Scene& scene_;
    const SightLimits limits_;
    const LightRig& rig_;
    const Medium& medium_;
    PictureScene picture_;
    PictureOptions options_;
    Integrator integrator_;
};

} // namespace

std::uint64_t sight_points(const Scene& scene, const SightLimits& limits, const ByteSource& eyes,
                           const ByteSink& rows, const Job& job) {
    if (!scene.rig || !scene.rig->medium)
        throw Error("", "", "sight needs a scene file with a rig and [fog]");
    const Lookout lookout(scene, limits, job);
    std::uint64_t count = 0;
    if (!rows(lookout.header())) return count;
    RayLineReader reader(eyes);
    const auto work = [&](Piece& piece) {
        ParsedRays parsed = rays_of(piece.lines);
        end_before_far_origins(parsed, piece.lines, scene.seen().bounds());
        piece.fault = std::move(parsed.fault);
        piece.rows = lookout.rows(parsed.rays);
        piece.eyes = parsed.rays.size();
    };
    stream_rows<Piece>(reader, rows, job, work, [&](const Piece& piece) { count += piece.eyes; });
    if (count == 0) throw Error("standard input", "", "holds no eyes");
    return count;
}

} // namespace keiko
