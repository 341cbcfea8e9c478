#include "keiko/render/panorama_film.h"

#include "keiko/base/parallel.h"
#include "keiko/maps/panorama.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/render/tiles.h"

#include <algorithm>

namespace keiko {
namespace {

/// Rows and columns of a picture of a view.
struct PanoramaSize {
    int width, height;

    explicit PanoramaSize(const PanoramaView& view)
        : width(view.width), height(std::max(view.width / 2, 1)) {
        if (view.layout == EnvironmentSpec::Layout::cube)
            width = 6 * view.width, height = view.width;
    }
};

/// Unit direction at a place of the picture, in pixels.
Vec3 direction_at(const PanoramaView& view, const PanoramaSize& size, int face, const Vec2& place) {
    if (view.layout == EnvironmentSpec::Layout::lat_long)
        return lat_long_direction({place.x / size.width, place.y / size.height});
    const double side = view.width;
    return cube_direction(static_cast<std::size_t>(face), {place.x / side - face, place.y / side});
}

Ray ray_of(const PanoramaView& view, const PanoramaSize& size, int x, int y) {
    const int face = view.layout == EnvironmentSpec::Layout::cube ? x / view.width : 0;
    const Vec2 middle(x + 0.5, y + 0.5);
    const auto at = [&](const Vec2& off) { return direction_at(view, size, face, middle + off); };
    Ray ray;
    ray.origin = view.eye;
    ray.direction = at(Vec2(0));
    RayDifferentials& spread = ray.differentials.emplace();
    spread.direction_dx = at({0.5, 0}) - at({-0.5, 0});
    spread.direction_dy = at({0, 0.5}) - at({0, -0.5});
    return ray;
}

} // namespace

Film render_panorama(const PictureScene& scene, const PanoramaView& view,
                     const PictureOptions& options, const Job& job) {
    const PanoramaSize size(view);
    Film film = blank_film(size.width, size.height, {});
    const Integrator integrator(scene, options, {}, job);
    parallel_for(static_cast<std::size_t>(size.height), job, "panorama", [&](std::size_t row) {
        const auto y = static_cast<int>(row);
        Rays rays;
        rays.reserve(static_cast<std::size_t>(size.width));
        for (int x = 0; x < size.width; ++x) rays.push_back(ray_of(view, size, x, y));
        write_row(film, 0, y, integrator.follow_mirrored(std::move(rays)).samples);
    });
    return film;
}

} // namespace keiko
