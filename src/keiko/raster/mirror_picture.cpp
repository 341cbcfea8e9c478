#include "keiko/raster/mirror_picture.h"

#include "keiko/base/parallel.h"
#include "keiko/intersect/hit/reflect_ray.h"

namespace keiko {
namespace {

/// True for a place within a row of lamps, or beside it by less than the distance of two.
bool is_at_lamps(const RigPlaneHit& hit) {
    const CPlaneFrame& row = *hit.frame;
    return hit.at.u >= 0 && hit.at.u <= row.length && hit.at.v >= row.first - row.pitch &&
           hit.at.v <= row.last() + row.pitch;
}

/// The pixel of a face that mirrors a ray, whose direction is unit.
MirrorPixel pixel_of(std::uint32_t face, const MetSurface& met, const Ray& mirrored,
                     const RigPlanes& lamps) {
    MirrorPixel pixel{face, met};
    const auto hit = lamps.nearest(mirrored.origin, mirrored.direction);
    pixel.coverage = lamps
                         .luminance(hit, mirrored.origin, mirrored.direction,
                                    mirrored.differentials, mirrored.t_max)
                         .coverage;
    if (!hit || !is_at_lamps(*hit)) return pixel;
    pixel.distance = hit->at.t;
    pixel.footprint = mirrored_pixel(mirrored, pixel.distance).value_or(0);
    return pixel;
}

/// A picture whose rows are made on several threads: `row_of`(y) has the pixels of one.
template <class RowOf>
MirrorPicture by_rows(const Camera& camera, const Job& job, const RowOf& row_of) {
    MirrorPicture picture{camera.width, camera.height, {}};
    const auto width = static_cast<std::size_t>(camera.width);
    picture.pixels.resize(width * static_cast<std::size_t>(camera.height));
    parallel_for(static_cast<std::size_t>(camera.height), job, "mirror", [&](std::size_t y) {
        const std::vector<MirrorPixel> row = row_of(static_cast<int>(y));
        std::copy(row.begin(), row.end(),
                  picture.pixels.begin() + static_cast<std::ptrdiff_t>(y * width));
    });
    return picture;
}

} // namespace

MirrorPicture mirror_picture(const Tracer& tracer, const SurfaceModel& model, const Camera& camera,
                             const RigPlanes& lamps, const Job& job) {
    const PreparedCamera prepared(camera);
    return by_rows(camera, job, [&](int y) {
        std::vector<Vec2> centres;
        for (int x = 0; x < camera.width; ++x) centres.emplace_back(x + 0.5, y + 0.5);
        const Rays rays = prepared.rays(centres);
        const FirstHits hits = tracer.first_hits(rays);
        std::vector<MirrorPixel> row(rays.size());
        for (std::size_t x = 0; x < rays.size(); ++x)
            if (const Hit* hit = hits[x])
                row[x] = pixel_of(model.faces[hit->face].id, {hit->t, hit->normal},
                                  reflect_ray(rays[x], *hit), lamps);
        return row;
    });
}

MirrorPicture mirror_picture(const MeshView& view, const RigPlanes& lamps, const Job& job) {
    const PreparedCamera prepared(view.camera());
    return by_rows(view.camera(), job, [&](int y) {
        std::vector<MirrorPixel> row(static_cast<std::size_t>(view.camera().width));
        for (int x = 0; x < view.camera().width; ++x) {
            const auto place = view.at(x, y);
            if (!place) continue;
            const Ray sight = prepared.ray(x + 0.5, y + 0.5);
            const double t = (place->position - sight.origin).dot(sight.direction);
            row[static_cast<std::size_t>(x)] =
                pixel_of(view.mesh().faces[place->triangle], {t, place->normal},
                         view.mirrored(x, y, *place), lamps);
        }
        return row;
    });
}

} // namespace keiko
