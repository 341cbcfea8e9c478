#include "keiko/render/reflection/sample_batch.h"

#include <algorithm>
#include <utility>

namespace keiko {
namespace {

/// Hilbert order of a square with a side that is a power of two.
GridPlace place_along(int number, int side) {
    GridPlace at;
    for (int half = 1; half < side; half *= 2, number /= 4) {
        const bool right = number % 4 >= 2, down = (number % 2 != 0) != right;
        if (!down) {
            if (right) at.x = half - 1 - at.x, at.y = half - 1 - at.y;
            std::swap(at.x, at.y);
        }
        if (right) at.x += half;
        if (down) at.y += half;
    }
    return at;
}

std::vector<GridPlace> order_of(int width, int height) {
    int side = 1;
    while (side < std::min(width, height)) side *= 2;
    std::vector<GridPlace> order;
    for (int y = 0; y < height; y += side)
        for (int x = 0; x < width; x += side)
            for (int number = 0; number < side * side; ++number) {
                GridPlace at = place_along(number, side);
                at.x += x, at.y += y;
                if (at.x >= width || at.y >= height) continue;
                at.number = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(at.x);
                order.push_back(at);
            }
    return order;
}

} // namespace

const std::vector<GridPlace>& hilbert_order(int width, int height) {
    thread_local std::pair<int, int> size{0, 0};
    thread_local std::vector<GridPlace> order;
    if (size != std::pair(width, height)) {
        order = order_of(width, height);
        size = {width, height};
    }
    return order;
}

SampleBatch without_border(SampleBatch view, int width) {
    const auto w = static_cast<std::size_t>(width);
    const std::size_t height = view.samples.size() / w;
    auto sample = view.samples.begin();
    for (std::size_t y = 1; y + 1 < height; ++y)
        for (std::size_t x = 1; x + 1 < w; ++x) *sample++ = view.samples[y * w + x];
    view.samples.erase(sample, view.samples.end());
    auto inner = view.points.begin();
    for (ShadingPoint& point : view.points) {
        const std::size_t x = point.sample % w, y = point.sample / w;
        if (x == 0 || y == 0 || x + 1 == w || y + 1 == height) continue;
        point.sample = (y - 1) * (w - 2) + x - 1;
        *inner++ = point;
    }
    view.points.erase(inner, view.points.end());
    return view;
}

} // namespace keiko
