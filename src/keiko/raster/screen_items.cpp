#include "keiko/raster/screen_items.h"

#include "keiko/base/parallel.h"
#include "keiko/raster/picture_volume.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace keiko {
namespace {

constexpr std::size_t chunk = 8192;
/// Place of a corner that has none in the picture.
constexpr auto nowhere = std::numeric_limits<std::int32_t>::min();

std::size_t chunks_of(std::size_t count) {
    return (count + chunk - 1) / chunk;
}

std::vector<ScreenCorner> screen_corners(const SurfaceMesh& mesh, const PictureVolume& volume,
                                         const Job& job) {
    std::vector<ScreenCorner> corners(mesh.positions.size());
    parallel_for(chunks_of(corners.size()), job, "", [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min(corners.size(), (c + 1) * chunk); ++i)
            corners[i] = volume.corner(mesh.positions[i]).value_or(ScreenCorner{nowhere, 0, 0});
    });
    return corners;
}

/// The items of a chunk of triangles.
std::vector<ScreenItem> items_of(const SurfaceMesh& mesh, const std::vector<ScreenCorner>& corners,
                                 const PictureVolume& volume, const PixelBox& picture,
                                 std::size_t number) {
    std::vector<ScreenItem> items;
    const auto add = [&](const ScreenTriangle& at, std::size_t triangle) {
        if (!pixels_of(at).within(picture).empty())
            items.push_back({at, static_cast<std::uint32_t>(triangle)});
    };
    const std::size_t end = std::min(mesh.triangles.size(), (number + 1) * chunk);
    for (std::size_t t = number * chunk; t < end; ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const ScreenTriangle at{corners[a], corners[b], corners[c]};
        if (at[0].x != nowhere && at[1].x != nowhere && at[2].x != nowhere)
            add(at, t);
        else
            for (const ScreenTriangle& part :
                 volume.clipped({mesh.positions[a], mesh.positions[b], mesh.positions[c]}))
                add(part, t);
    }
    return items;
}

} // namespace

ScreenItems screen_items(const SurfaceMesh& mesh, const Camera& camera, const Job& job) {
    const PictureVolume volume(camera, mesh.positions);
    const std::vector<ScreenCorner> corners = screen_corners(mesh, volume, job);
    const PixelBox picture{0, 0, camera.width - 1, camera.height - 1};
    ScreenItems items(chunks_of(mesh.triangles.size()));
    parallel_for(items.size(), job, "",
                 [&](std::size_t c) { items[c] = items_of(mesh, corners, volume, picture, c); });
    return items;
}

} // namespace keiko
