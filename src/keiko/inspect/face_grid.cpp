#include "keiko/inspect/face_grid.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

void keep_distinct(std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

std::size_t index_of(const std::vector<double>& sorted, double value) {
    return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) -
                                    sorted.begin());
}

/// Length of the longest row of control points along u, and along v.
Vec2 extents(const PlacedPatch& patch, const BezierPatchView& view) {
    const auto at = [&](int i, int j) {
        const Vec4& p = patch.points[static_cast<std::size_t>(i * (view.degree_v + 1) + j)];
        return Vec3(p.x, p.y, p.z) / p.w;
    };
    Vec2 longest(0);
    for (int j = 0; j <= view.degree_v; ++j) {
        double length = 0;
        for (int i = 1; i <= view.degree_u; ++i) length += (at(i, j) - at(i - 1, j)).length();
        longest.x = std::max(longest.x, length);
    }
    for (int i = 0; i <= view.degree_u; ++i) {
        double length = 0;
        for (int j = 1; j <= view.degree_v; ++j) length += (at(i, j) - at(i, j - 1)).length();
        longest.y = std::max(longest.y, length);
    }
    return longest;
}

/// Places in the middles of equal parts of each span, no further apart than `spacing`.
void spread(const std::vector<double>& lengths, double spacing, std::vector<double>& places,
            std::vector<double>& widths) {
    constexpr double most = 1000; // of one span
    for (std::size_t span = 0; span < lengths.size(); ++span) {
        const auto parts =
            static_cast<std::size_t>(std::clamp(std::ceil(lengths[span] / spacing), 1.0, most));
        const double width = 1 / static_cast<double>(parts);
        for (std::size_t k = 0; k < parts; ++k) {
            places.push_back(static_cast<double>(span) + (static_cast<double>(k) + 0.5) * width);
            widths.push_back(width);
        }
    }
}

} // namespace

FaceGrid::FaceGrid(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face,
                   double spacing)
    : model_(model),
      face_(model.faces[face]),
      trims_(model, face_),
      sign_(face_.reversed != model.instances[instance].transform.mirrored() ? -1 : 1) {
    arrange(instance);
    choose_places(spacing);
    samples_.reserve(u_.size() * v_.size());
    for (std::size_t row = 0; row < v_.size(); ++row)
        for (std::size_t column = 0; column < u_.size(); ++column) {
            samples_.push_back(sampled(place(column, row)));
            samples_.back().area *= width_u_[column] * width_v_[row];
        }
}

void FaceGrid::arrange(std::uint32_t instance) {
    std::vector<Vec2> corners;
    for (std::uint32_t i = 0; i < face_.patch_count; ++i) {
        const std::uint32_t patch = face_.first_patch + i;
        patches_.emplace_back(model_, patch, model_.instances[instance].transform);
        corners.push_back(model_.face_parameters(patch, Vec2(0)));
        spans_u_.push_back(corners.back().x);
        spans_v_.push_back(corners.back().y);
    }
    keep_distinct(spans_u_), keep_distinct(spans_v_);
    table_.assign(spans_u_.size() * spans_v_.size(), no_index);
    for (std::uint32_t i = 0; i < face_.patch_count; ++i)
        table_[index_of(spans_v_, corners[i].y) * spans_u_.size() +
               index_of(spans_u_, corners[i].x)] = i;
}

void FaceGrid::choose_places(double spacing) {
    std::vector<double> lengths_u(spans_u_.size(), 0), lengths_v(spans_v_.size(), 0);
    for (std::size_t v = 0; v < spans_v_.size(); ++v)
        for (std::size_t u = 0; u < spans_u_.size(); ++u) {
            const std::uint32_t i = table_[v * spans_u_.size() + u];
            if (i == no_index) continue;
            const Vec2 lengths = extents(patches_[i], model_.patch(patches_[i].index));
            lengths_u[u] = std::max(lengths_u[u], lengths.x);
            lengths_v[v] = std::max(lengths_v[v], lengths.y);
        }
    spread(lengths_u, spacing, u_, width_u_);
    spread(lengths_v, spacing, v_, width_v_);
}

std::uint32_t FaceGrid::patch_at(const Vec2& place) const {
    const double u = std::floor(place.x), v = std::floor(place.y);
    if (!(u >= 0 && v >= 0)) return no_index;
    const auto column = static_cast<std::size_t>(u), row = static_cast<std::size_t>(v);
    if (column >= spans_u_.size() || row >= spans_v_.size()) return no_index;
    return table_[row * spans_u_.size() + column];
}

std::optional<SurfaceDerivatives> FaceGrid::evaluate(const Vec2& place, int order) const {
    const std::uint32_t index = patch_at(place);
    if (index == no_index) return std::nullopt;
    const PlacedPatch& patch = patches_[index];
    const Vec2 uv(place.x - std::floor(place.x), place.y - std::floor(place.y));
    if (!trims_.untrimmed() && !trims_.contains(model_.face_parameters(patch.index, uv)))
        return std::nullopt;
    const BezierPatchView original = model_.patch(patch.index);
    SurfaceDerivatives s =
        keiko::evaluate({original.degree_u, original.degree_v, patch.points}, uv, order);
    s.d[0][0] += patch.middle;
    return s;
}

FaceSample FaceGrid::sampled(const Vec2& place) const {
    FaceSample sample;
    const auto s = evaluate(place, 2);
    if (!s) return sample;
    const Vec3 cross = s->du().cross(s->dv());
    const double area = cross.length(), u2 = s->du().length2(), v2 = s->dv().length2();
    constexpr double beside_a_pole = 1e-3;
    if (!(area > beside_a_pole * std::max(u2, v2))) return sample;
    sample.position = s->position();
    sample.normal = cross * (sign_ / area);
    sample.bend_u = s->duu().dot(sample.normal) / u2;
    sample.bend_v = s->dvv().dot(sample.normal) / v2;
    sample.area = area;
    sample.material = true;
    return sample;
}

} // namespace keiko
