#include "keiko/raster/z_buffer.h"

#include "keiko/raster/depth_tile.h"
#include "keiko/raster/tile_items.h"

namespace keiko {

ItemBuffer z_buffer(const SurfaceMesh& mesh, const Camera& camera, const Job& job) {
    return drawn_by_tiles(mesh, camera, {camera.width, camera.height}, job,
                          [](const auto& each_item, const PixelBox& window, ItemBuffer& seen) {
                              DepthTile tile(window);
                              each_item([&](const ScreenItem& item) {
                                  tile.add(item.at, [&](int x, int y) {
                                      seen.shown[seen.index(x, y)] = item.triangle;
                                  });
                              });
                          });
}

} // namespace keiko
