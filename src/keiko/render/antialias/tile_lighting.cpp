#include "keiko/render/antialias/tile_lighting.h"

#include "keiko/render/antialias/edge_pixel_lighting.h"
#include "keiko/render/lighting/light_interpolation.h"
#include "keiko/render/lighting/unshadowed_light.h"

#include <map>
#include <utility>
#include <vector>

namespace keiko {
namespace {

/// Places of one depth, each with the points that have its light, and their samples.
struct LitTogether {
    struct Taker {
        const ShadingPoint* point;
        PixelSample* sample;
    };

    std::vector<LitPlace> places;
    std::vector<std::vector<Taker>> takers; ///< by place
};

/// The places to be lit in a tile, by depth.
std::map<int, LitTogether> lit_places(int width, const std::vector<bool>& in_parts,
                                      SampleBatch& view, RefinedPixels& refined) {
    std::map<int, LitTogether> all;
    for (const ShadingPoint& point : view.points) {
        if (in_parts[point.sample]) continue;
        const auto number = static_cast<int>(point.sample);
        PixelSample& sample = view.samples[point.sample];
        LitTogether& lit = all[point.depth];
        lit.places.push_back({{number % width, number / width}, &point, sample.luminance});
        lit.takers.push_back({{&point, &sample}});
    }
    for (const SharedPlace& shared : shared_places(width, refined)) {
        const ShadingPoint& point = *shared.lit.point;
        LitTogether& lit = all[point.depth];
        const auto sample = [&](const ShadingPoint& of) {
            return &refined.parts[of.sample].sample;
        };
        lit.places.push_back({shared.lit.pixel, &point, sample(point)->luminance});
        lit.takers.emplace_back();
        for (const OutlineSpot& spot : shared.points)
            lit.takers.back().push_back({spot.point, sample(*spot.point)});
    }
    return all;
}

} // namespace

void add_tile_light(const Integrator& integrator, int width, double error, SampleBatch& view,
                    RefinedPixels& refined) {
    std::vector<bool> in_parts(view.samples.size());
    for (const Subpixel& part : refined.parts) in_parts[part.pixel] = true;
    if (!integrator.light_is_smooth()) {
        add_shared_light(integrator, width, error, refined);
        return add_interpolated_light(integrator, width, in_parts, error, view);
    }
    for (const auto& [depth, lit] : lit_places(width, in_parts, view, refined)) {
        const std::vector<DirectLight> light = unshadowed_light(integrator, lit.places, error);
        for (std::size_t i = 0; i < light.size(); ++i)
            for (const auto& [point, sample] : lit.takers[i])
                integrator.add_light(*point, light[i], *sample);
    }
}

} // namespace keiko
