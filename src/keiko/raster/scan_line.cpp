#include "keiko/raster/scan_line.h"

#include "keiko/base/parallel.h"
#include "keiko/raster/screen_items.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace keiko {
namespace {

constexpr int band_rows = 32; // rows of a thread at a time

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

/// Sorts by first pixels what is nearly sorted.
void sort_spans(std::vector<ActiveTriangle>& active) {
    for (std::size_t i = 1; i < active.size(); ++i)
        for (std::size_t j = i; j > 0 && active[j].first() < active[j - 1].first(); --j)
            std::swap(active[j], active[j - 1]);
}

/// Writes the row of sorted spans from left to right.
void write_row(const std::vector<ActiveTriangle>& active, int y, ItemBuffer& seen) {
    std::vector<const ActiveTriangle*> over; // the spans at x
    std::size_t next = 0;
    for (int x = 0; x < seen.width;) {
        while (next < active.size() && active[next].first() <= x) over.push_back(&active[next++]);
        std::erase_if(over, [&](const ActiveTriangle* span) { return span->last() < x; });
        if (over.empty() && next == active.size()) return;
        if (over.empty()) {
            x = active[next].first();
            continue;
        }
        int end = next < active.size() ? active[next].first() : seen.width;
        for (const ActiveTriangle* span : over) end = std::min(end, span->last() + 1);
        for (; x < end; ++x) {
            const ActiveTriangle* nearest = over.front();
            for (const ActiveTriangle* span : over)
                if (span != nearest && span->hides(*nearest, x)) nearest = span;
            seen.shown[seen.index(x, y)] = nearest->triangle();
        }
    }
}

void scan_band(std::vector<ActiveTriangle> waiting, int first, int last, ItemBuffer& seen) {
    std::stable_sort(waiting.begin(), waiting.end(),
                     [](const ActiveTriangle& a, const ActiveTriangle& b) {
                         return a.first_row() < b.first_row();
                     });
    std::vector<ActiveTriangle> active;
    std::size_t next = 0;
    for (int y = first; y <= last; ++y) {
        std::erase_if(active, [&](const ActiveTriangle& one) { return one.ends_before(y); });
        for (ActiveTriangle& one : active) one.advance();
        while (next < waiting.size() && waiting[next].first_row() == y)
            active.push_back(waiting[next++]);
        sort_spans(active);
        write_row(active, y, seen);
    }
}

} // namespace

ItemBuffer scan_line(const SurfaceMesh& mesh, const Camera& camera, const Job& job) {
    const ScreenItems items = screen_items(mesh, camera, job);
    ItemBuffer seen(camera.width, camera.height);
    const int bands = (camera.height + band_rows - 1) / band_rows;
    parallel_for(static_cast<std::size_t>(bands), job, "", [&](std::size_t band) {
        const int first = static_cast<int>(band) * band_rows;
        const int last = std::min(first + band_rows, camera.height) - 1;
        const PixelBox window{0, first, camera.width - 1, last};
        std::vector<ActiveTriangle> met;
        for (const std::vector<ScreenItem>& chunk : items)
            for (const ScreenItem& item : chunk)
                if (!pixels_of(item.at).within(window).empty()) {
                    met.emplace_back(item, window);
                    if (met.back().ends_before(first)) met.pop_back(); // without area
                }
        scan_band(std::move(met), first, last, seen);
    });
    return seen;
}

} // namespace keiko
