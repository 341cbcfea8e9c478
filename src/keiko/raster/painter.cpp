#include "keiko/raster/painter.h"

#include "keiko/raster/tile_items.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace keiko {
namespace {

/// Share of the nearness of a plane within which a place lies on it: far above rounding.
constexpr double on_plane = 1e-9;

double in_pixels(std::int32_t at) {
    return at / static_cast<double>(subpixels);
}

/// Nearness of a triangle's plane over the picture.
class PicturePlane {
public:
    explicit PicturePlane(const TriangleFunctions& f)
        : per_x_(f.nearness.step_x),
          per_y_(f.nearness.step_y),
          start_(f.nearness.start),
          x_(f.box.first_x + 0.5),
          y_(f.box.first_y + 0.5) {}

    /// At a place in pixels.
    double at(double x, double y) const { return start_ + per_x_ * (x - x_) + per_y_ * (y - y_); }

private:
    double per_x_, per_y_, start_, x_, y_;
};

/// A triangle of a tile.
struct Painted {
    const ScreenItem* item;
    TriangleFunctions functions;
    PicturePlane plane;

    Painted(const ScreenItem& of, const PixelBox& window)
        : item(&of), functions(of.at, window), plane(functions) {}
};

/// A part of a triangle: what lies before, or not before, the planes of others.
struct PaintedPart {
    const Painted* whole;
    std::vector<std::pair<const Painted*, bool>>
        cuts{}; ///< a plane, and whether the part is before
};

/// Side of a part of a plane, by the corners of the whole.
enum class PlaneSide { on, behind, before, both };

PlaneSide side_of(const Painted& triangle, const Painted& plane) {
    bool before = false, behind = false;
    for (const ScreenCorner& corner : triangle.item->at) {
        const double of_plane = plane.plane.at(in_pixels(corner.x), in_pixels(corner.y));
        const double off = corner.nearness - of_plane;
        const double rounding = on_plane * std::max(std::abs(of_plane), std::abs(corner.nearness));
        before |= off > rounding, behind |= off < -rounding;
    }
    if (before && behind) return PlaneSide::both;
    return before ? PlaneSide::before : behind ? PlaneSide::behind : PlaneSide::on;
}

/// Paints a part, over what is there.
void paint(const PaintedPart& part, const PixelBox& window, ItemBuffer& seen) {
    scan_triangle(part.whole->item->at, window, [&](int x, int y, double nearness) {
        for (const auto& [plane, before] : part.cuts)
            if ((nearness > plane->plane.at(x + 0.5, y + 0.5)) != before) return;
        seen.shown[seen.index(x, y)] = part.whole->item->triangle;
    });
}

/// Parts by their sides of the plane of one of them.
struct SplitParts {
    std::vector<PaintedPart> behind{}, on{}, before{};
};

SplitParts split(std::vector<PaintedPart> parts) {
    const Painted& plane = *parts[parts.size() / 2].whole;
    SplitParts sides;
    for (PaintedPart& part : parts) {
        const PlaneSide side = part.whole == &plane ? PlaneSide::on : side_of(*part.whole, plane);
        if (side == PlaneSide::both) {
            sides.behind.push_back(part);
            sides.behind.back().cuts.emplace_back(&plane, false);
            part.cuts.emplace_back(&plane, true);
        }
        std::vector<PaintedPart>& own = side == PlaneSide::on       ? sides.on
                                        : side == PlaneSide::behind ? sides.behind
                                                                    : sides.before;
        own.push_back(std::move(part));
    }
    return sides;
}

/// Parts that are still to be painted.
struct OpenParts {
    std::vector<PaintedPart> parts;
    bool on_one_plane = false;
};

/// Paints parts from the back to the front: those behind the plane of one of them, those on it, the
/// last of the mesh first, and those before it. Only the open sides are kept: however they lie,
/// each part is held once.
void paint_sorted(std::vector<PaintedPart> parts, const PixelBox& window, ItemBuffer& seen) {
    std::vector<OpenParts> open; // the farthest last
    open.push_back({std::move(parts)});
    while (!open.empty()) {
        OpenParts next = std::move(open.back());
        open.pop_back();
        if (next.on_one_plane || next.parts.size() < 2) {
            for (auto part = next.parts.rbegin(); part != next.parts.rend(); ++part)
                paint(*part, window, seen);
            continue;
        }
        SplitParts sides = split(std::move(next.parts));
        open.push_back({std::move(sides.before)});
        open.push_back({std::move(sides.on), true});
        open.push_back({std::move(sides.behind)});
    }
}

template <class EachItem>
void paint_tile(const EachItem& each_item, const PixelBox& window, ItemBuffer& seen) {
    std::vector<Painted> triangles;
    each_item([&](const ScreenItem& item) {
        triangles.emplace_back(item, window);
        if (triangles.back().functions.box.empty()) triangles.pop_back(); // without area
    });
    std::vector<PaintedPart> parts;
    for (const Painted& triangle : triangles) parts.push_back({&triangle});
    paint_sorted(std::move(parts), window, seen);
}

} // namespace

ItemBuffer painted_triangles(const SurfaceMesh& mesh, const Camera& camera, const Job& job) {
    return drawn_by_tiles(mesh, camera, {camera.width, camera.height}, job,
                          [](const auto& each_item, const PixelBox& window, ItemBuffer& seen) {
                              paint_tile(each_item, window, seen);
                          });
}

} // namespace keiko
