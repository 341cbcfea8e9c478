#include "keiko/render/antialias/shared_light.h"

#include "keiko/render/antialias/outline_rows.h"
#include "keiko/render/lighting/interpolated_light.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace keiko {
namespace {

using Spots = std::vector<OutlineSpot>;

/// The spots of one depth, whose light goes to the parts of pixels.
class SharedLight {
public:
    SharedLight(const Integrator& integrator, double error, std::vector<PixelPart>& parts)
        : integrator_(integrator), error_(error), parts_(parts) {}

    /// Spots of one pixel.
    void add(Spots spots) {
        for (Spots& surface : smooth_surfaces(std::move(spots))) {
            const OutlineSpot place = amid(surface);
            places_.push_back(place);
            surfaces_[place.spot] = std::move(surface);
        }
    }
    /// Lights what has been added.
    void light() const {
        for (const OutlineRow& row : outline_rows(places_)) {
            const SpotGrid grid(row.spots, row.along);
            const std::vector<SpotLight> light =
                interpolated_light(integrator_, grid, seen(row), {}, error_);
            for (std::size_t i = 0; i < light.size(); ++i)
                for (const OutlineSpot& spot : surfaces_.at(row.spots[i]))
                    integrator_.add_light(*spot.spot, light[i], part_of(*spot.spot).sample);
        }
    }

private:
    PixelPart& part_of(const LitSpot& spot) const { return parts_[spot.sample]; }
    /// The one nearest to the mean place of all, by their shares.
    OutlineSpot amid(const Spots& surface) const {
        Vec3 sum(0);
        double shares = 0;
        for (const OutlineSpot& spot : surface) {
            sum += spot.spot->place.position * part_of(*spot.spot).share;
            shares += part_of(*spot.spot).share;
        }
        const Vec3 mean = sum / shares;
        const auto off = [&](const OutlineSpot& spot) {
            return (spot.spot->place.position - mean).length2();
        };
        return *std::min_element(surface.begin(), surface.end(),
                                 [&](const auto& a, const auto& b) { return off(a) < off(b); });
    }
    std::vector<Rgb> seen(const OutlineRow& row) const {
        std::vector<Rgb> seen;
        for (const LitSpot* spot : row.spots) seen.push_back(part_of(*spot).sample.luminance);
        return seen;
    }

    const Integrator& integrator_;
    double error_;
    std::vector<PixelPart>& parts_;
    Spots places_;
    std::map<const LitSpot*, Spots> surfaces_; ///< by the one of them that is lit
};

} // namespace

void add_shared_light(const Integrator& integrator, int width, double error,
                      RefinedPixels& refined) {
    std::vector<LitSpot>& spots = refined.spots;
    const auto pixel = [&](const LitSpot& spot) { return refined.parts[spot.sample].pixel; };
    const auto order = [&](const LitSpot& spot) {
        return std::tuple(spot.depth, pixel(spot), spot.sample);
    };
    std::stable_sort(spots.begin(), spots.end(),
                     [&](const LitSpot& a, const LitSpot& b) { return order(a) < order(b); });
    each_depth(spots, [&](std::span<const LitSpot> of_depth) {
        SharedLight shared(integrator, error, refined.parts);
        for (std::size_t i = 0; i < of_depth.size();) {
            Spots of_pixel;
            const std::size_t number = pixel(of_depth[i]);
            const auto w = static_cast<std::size_t>(width);
            const Pixel place{static_cast<int>(number % w), static_cast<int>(number / w)};
            for (; i < of_depth.size() && pixel(of_depth[i]) == number; ++i)
                of_pixel.push_back({place, &of_depth[i]});
            shared.add(std::move(of_pixel));
        }
        shared.light();
    });
}

} // namespace keiko
