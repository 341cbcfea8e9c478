#include "keiko/compare/alignment/surface_samples.h"

#include <algorithm>
#include <cmath>

namespace keiko {

double sample_spacing(const ClosestPointQuery& body, std::size_t count) {
    double area = 0;
    for (std::size_t i = 0; i < body.piece_count(); ++i)
        area += body.piece_size(i).x * body.piece_size(i).y;
    return std::sqrt(area / static_cast<double>(count));
}

std::vector<SurfaceSample> piece_samples(const ClosestPointQuery& body, std::size_t piece,
                                         double spacing, int least) {
    constexpr int most = 256;
    const auto cells = [&](double length) {
        return static_cast<int>(
            std::clamp(std::ceil(length / spacing), double(least), double{most}));
    };
    const Vec2 size = body.piece_size(piece);
    const int nu = cells(size.x), nv = cells(size.y);
    std::vector<SurfaceSample> samples;
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j) {
            const auto point = body.point(piece, {(i + 0.5) / nu, (j + 0.5) / nv});
            if (!point) continue;
            const Vec2 cell(1.0 / nu, 1.0 / nv);
            samples.push_back({*point, point->stretch * cell.x * cell.y, cell});
        }
    return samples;
}

} // namespace keiko
