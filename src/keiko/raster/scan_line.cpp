#include "keiko/raster/scan_line.h"

#include "keiko/raster/tile_items.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace keiko {
namespace {

/// Rounded down and up, for a divisor above 0.
std::int64_t floor_of(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}
std::int64_t ceil_of(std::int64_t a, std::int64_t b) {
    return -floor_of(-a, b);
}

/// A triangle that meets the row.
class ActiveTriangle {
public:
    ActiveTriangle(const ScreenItem& item, const PixelBox& window)
        : functions_(item.at, window), triangle_(item.triangle) {
        find_span();
    }

    int first_row() const { return functions_.box.first_y; }
    bool ends_before(int row) const { return functions_.box.last_y < row; }
    /// The first and the last pixel of the row that it covers; none if the last is before.
    int first() const { return first_; }
    int last() const { return last_; }
    std::uint32_t triangle() const { return triangle_; }
    /// True if it is before another at a pixel that both cover.
    bool hides(const ActiveTriangle& other, int x) const {
        const double own = nearness(x), others = other.nearness(x);
        return own > others || (own == others && triangle_ < other.triangle_);
    }
    void advance() {
        functions_.advance();
        find_span();
    }

private:
    double nearness(int x) const {
        return functions_.nearness.start +
               (x - functions_.box.first_x) * functions_.nearness.step_x;
    }
    void find_span() {
        const std::int64_t width = functions_.box.last_x - functions_.box.first_x;
        std::int64_t low = 0, high = width;
        for (const auto& edge : functions_.edges)
            if (edge.step_x > 0)
                low = std::max(low, ceil_of(-edge.start, edge.step_x));
            else if (edge.step_x < 0)
                high = std::min(high, floor_of(edge.start, -edge.step_x));
            else if (edge.start < 0)
                high = -1;
        low = std::min(low, width + 1), high = std::max(high, std::int64_t{-1});
        first_ = functions_.box.first_x + static_cast<int>(low);
        last_ = functions_.box.first_x + static_cast<int>(high);
    }

    TriangleFunctions functions_;
    std::uint32_t triangle_;
    int first_ = 0, last_ = -1;
};

/// Spans of a row, by their first pixels.
using SortedSpans = std::vector<ActiveTriangle*>;

bool begins_before(const ActiveTriangle* a, const ActiveTriangle* b) {
    return a->first() < b->first();
}

/// Sorts spans whose first ones are nearly sorted, and the others not.
void sort_spans(SortedSpans& spans, std::size_t nearly) {
    for (std::size_t i = 1; i < nearly; ++i)
        for (std::size_t j = i; j > 0 && begins_before(spans[j], spans[j - 1]); --j)
            std::swap(spans[j], spans[j - 1]);
    const auto others = spans.begin() + static_cast<std::ptrdiff_t>(nearly);
    std::stable_sort(others, spans.end(), begins_before);
    std::inplace_merge(spans.begin(), others, spans.end(), begins_before);
}

/// Writes the row of sorted spans from left to right.
void write_row(const SortedSpans& active, int y, ItemBuffer& seen) {
    std::vector<const ActiveTriangle*> over; // the spans at x
    std::size_t next = 0;
    for (int x = 0; x < seen.width;) {
        while (next < active.size() && active[next]->first() <= x) over.push_back(active[next++]);
        std::erase_if(over, [&](const ActiveTriangle* span) { return span->last() < x; });
        if (over.empty() && next == active.size()) return;
        if (over.empty()) {
            x = active[next]->first();
            continue;
        }
        int end = next < active.size() ? active[next]->first() : seen.width;
        for (const ActiveTriangle* span : over) end = std::min(end, span->last() + 1);
        for (; x < end; ++x) {
            const ActiveTriangle* nearest = over.front();
            for (const ActiveTriangle* span : over)
                if (span != nearest && span->hides(*nearest, x)) nearest = span;
            seen.shown[seen.index(x, y)] = nearest->triangle();
        }
    }
}

template <class EachItem>
std::vector<ActiveTriangle> triangles_of(const EachItem& each_item, const PixelBox& window) {
    std::vector<ActiveTriangle> triangles;
    each_item([&](const ScreenItem& item) {
        triangles.emplace_back(item, window);
        if (triangles.back().ends_before(window.first_y)) triangles.pop_back(); // without area
    });
    return triangles;
}

template <class EachItem>
void scan_band(const EachItem& each_item, const PixelBox& window, ItemBuffer& seen) {
    std::vector<ActiveTriangle> triangles = triangles_of(each_item, window);
    SortedSpans waiting, active;
    for (ActiveTriangle& triangle : triangles) waiting.push_back(&triangle);
    std::stable_sort(waiting.begin(), waiting.end(),
                     [](const ActiveTriangle* a, const ActiveTriangle* b) {
                         return a->first_row() < b->first_row();
                     });
    std::size_t next = 0;
    for (int y = window.first_y; y <= window.last_y; ++y) {
        std::erase_if(active, [&](const ActiveTriangle* one) { return one->ends_before(y); });
        for (ActiveTriangle* one : active) one->advance();
        const std::size_t before = active.size();
        while (next < waiting.size() && waiting[next]->first_row() == y)
            active.push_back(waiting[next++]);
        sort_spans(active, before);
        write_row(active, y, seen);
    }
}

} // namespace

ItemBuffer scan_line(const SurfaceMesh& mesh, const Camera& camera, const Job& job) {
    // Bands of 32 rows, as wide as any picture.
    const TileGrid bands{camera.width, camera.height, 20, 5};
    return drawn_by_tiles(mesh, camera, bands, job,
                          [](const auto& each_item, const PixelBox& window, ItemBuffer& seen) {
                              scan_band(each_item, window, seen);
                          });
}

} // namespace keiko
