#include "keiko/film/signed_color_picture.h"
#include "keiko/report/content/mesh_files.h"

#include <algorithm>
#include <cmath>

namespace keiko {

ValueRange color_range(const MeshField& field) {
    constexpr double share = 0.98;
    std::vector<double> sizes;
    for (const double value : field.values)
        if (std::isfinite(value)) sizes.push_back(std::abs(value));
    if (sizes.empty()) return {-1, 1};
    const auto rank = static_cast<std::size_t>(share * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(rank), sizes.end());
    const double most = sizes[rank] > 0 ? round_scale(sizes[rank]) : 1;
    return {-most, most};
}

std::vector<Rgb> corner_colors(const SurfaceMesh& mesh, const std::optional<ValueRange>& range) {
    if (mesh.fields.empty()) return std::vector<Rgb>(mesh.positions.size(), signed_color(0));
    const MeshField& field = mesh.fields.front();
    const ValueRange scale = range.value_or(color_range(field));
    std::vector<Rgb> colors;
    for (const double value : field.values)
        colors.push_back(std::isnan(value) ? Rgb(0.25) : signed_color(signed_share(value, scale)));
    return colors;
}

} // namespace keiko
