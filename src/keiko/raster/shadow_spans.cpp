#include "keiko/raster/shadow_spans.h"

#include "keiko/math/interval_set.h"
#include "keiko/raster/light_pyramid.h"
#include "keiko/raster/lit_pixels.h"
#include "keiko/raster/row_section.h"

#include <algorithm>
#include <array>
#include <vector>

namespace keiko {
namespace {

/// Pixels of a row that show one triangle.
struct Span {
    std::uint32_t triangle;
    int y, first, last;
};

/// The parts of a span that triangles shade, from its left end, 0, to its right one, 1.
IntervalSet shaded_parts(const LightPyramid& pyramid, const ShadowCasters& casters,
                         const Viewpoint& light, std::uint32_t own) {
    std::vector<ParameterInterval> parts;
    casters.tree().any_of(
        [&](const Box3& box) { return pyramid.meets(box); },
        [&](std::uint32_t triangle) {
            if (triangle == own || casters.hold(triangle, light)) return false;
            ParameterInterval part{1, 0};
            for (const Vec3& shares : pyramid.shadow_of(casters.corners(triangle)))
                part = {std::min(part.begin, shares.y), std::max(part.end, shares.y)};
            if (part.begin < part.end) parts.push_back(part);
            return false;
        });
    return IntervalSet(std::move(parts));
}

/// Lights the rows of a picture.
class SpanLighting {
public:
    SpanLighting(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light)
        : view_(view), casters_(casters), light_(light), picture_(view.camera()) {}

    void put(const Span& span, Image& lit) const {
        const RowSection section(view_.corners(span.triangle), picture_, span.y + 0.5);
        const double begin = section.share_at(span.first), end = section.share_at(span.last + 1);
        const std::array<Vec3, 2> ends{section.place(begin), section.place(end)};
        const LightPyramid pyramid(ends, light_, casters_.rounding());
        const bool is_line = (ends[1] - ends[0]).length() > casters_.rounding() && pyramid.lights();
        const IntervalSet shaded =
            is_line ? shaded_parts(pyramid, casters_, light_, span.triangle) : IntervalSet();
        for (int x = span.first; x <= span.last; ++x) {
            const double share = section.share_at(x + 0.5);
            const bool dark = is_line ? shaded.contains((share - begin) / (end - begin))
                                      : casters_.hide(section.place(share), light_, span.triangle);
            *lit.pixel(x, span.y) = dark ? 0.0F : 1.0F;
        }
    }

private:
    const MeshView& view_;
    const ShadowCasters& casters_;
    const Viewpoint& light_;
    PictureMap picture_;
};

} // namespace

Image lit_by_spans(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                   const Job& job) {
    const ItemBuffer& items = view.items();
    const SpanLighting lighting(view, casters, light);
    Image lit(items.width, items.height, 1);
    parallel_for(static_cast<std::size_t>(items.height), job, "shadows", [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < items.width;) {
            Span span{items.at(x, y), y, x, x};
            while (++x < items.width && items.at(x, y) == span.triangle) span.last = x;
            if (span.triangle != no_index && faces_light(view, span.triangle, light))
                lighting.put(span, lit);
        }
    });
    return lit;
}

} // namespace keiko
