#include "keiko/inspect/flaws/face_surface.h"

#include "keiko/geometry/bezier/differential_geometry.h"

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

/// The span that holds a face parameter, or the one next to it.
std::size_t span_of(const std::vector<double>& begins, double parameter) {
    const auto beyond = std::upper_bound(begins.begin(), begins.end(), parameter);
    return beyond == begins.begin() ? 0 : static_cast<std::size_t>(beyond - begins.begin()) - 1;
}

/// Length of the longest row of control points along u, and along v.
Vec2 extents(const PlacedPatch& patch, const BezierPatchView& view) {
    const auto at = [&](int i, int j) {
        const int index = i * (view.degree_v + 1) + j;
        const Vec4& p = patch.points[static_cast<std::size_t>(index)];
        return euclidean(p);
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

/// True if the control points from `first` on, `step` apart, are within `coincident` mm of it.
bool is_point(const PlacedPatch& patch, std::size_t first, std::size_t step, std::size_t count,
              double coincident) {
    const auto at = [&](std::size_t k) { return euclidean(patch.points[first + k * step]); };
    for (std::size_t k = 1; k < count; ++k)
        if (!((at(k) - at(0)).length() <= coincident)) return false;
    return true;
}

} // namespace

FaceSurface::FaceSurface(const SurfaceModel& model, std::uint32_t instance, std::uint32_t index)
    : model_(model),
      trims_(model, model.faces[index]),
      sign_(model.faces[index].reversed != model.instances[instance].transform.mirrored() ? -1
                                                                                          : 1) {
    const Face& face = model.faces[index];
    std::vector<Vec2> corners;
    for (std::uint32_t i = 0; i < face.patch_count; ++i) {
        const std::uint32_t patch = face.first_patch + i;
        patches_.emplace_back(model_, patch, model_.instances[instance].transform);
        corners.push_back(model_.face_parameters(patch, Vec2(0)));
        begins_u_.push_back(corners.back().x);
        begins_v_.push_back(corners.back().y);
    }
    keep_distinct(begins_u_), keep_distinct(begins_v_);
    table_.assign(begins_u_.size() * begins_v_.size(), no_index);
    for (std::uint32_t i = 0; i < face.patch_count; ++i)
        table_[index_of(begins_v_, corners[i].y) * begins_u_.size() +
               index_of(begins_u_, corners[i].x)] = i;
}

bool FaceSurface::is_grid() const {
    return std::find(table_.begin(), table_.end(), no_index) == table_.end();
}

double FaceSurface::size() const {
    Box3 box;
    for (const PlacedPatch& patch : patches_) {
        const BezierPatchView original = model_.patch(patch.index);
        const BezierPatchView view{original.degree_u, original.degree_v, patch.points};
        for (const Vec2& corner : {Vec2(0, 0), Vec2(0, 1), Vec2(1, 0), Vec2(1, 1)})
            box.extend(keiko::evaluate(view, corner, 0).position() + patch.middle);
    }
    return box.size();
}

std::uint32_t FaceSurface::patch_at(const Vec2& place, Vec2& uv) const {
    constexpr double beyond = 0.25;
    const auto columns = static_cast<double>(spans_u()), rows = static_cast<double>(spans_v());
    if (!(place.x >= -beyond && place.x <= columns + beyond && place.y >= -beyond &&
          place.y <= rows + beyond))
        return no_index;
    const double u = std::clamp(std::floor(place.x), 0.0, columns - 1);
    const double v = std::clamp(std::floor(place.y), 0.0, rows - 1);
    uv = place - Vec2(u, v);
    return patch_in(static_cast<std::size_t>(u), static_cast<std::size_t>(v));
}

std::optional<SurfaceDerivatives> FaceSurface::evaluate_beyond(const Vec2& place, int order) const {
    Vec2 uv(0);
    const std::uint32_t index = patch_at(place, uv);
    if (index == no_index) return std::nullopt;
    const PlacedPatch& patch = patches_[index];
    const BezierPatchView original = model_.patch(patch.index);
    SurfaceDerivatives s =
        keiko::evaluate({original.degree_u, original.degree_v, patch.points}, uv, order);
    s.d[0][0] += patch.middle;
    return s;
}

bool FaceSurface::has_material(const Vec2& place) const {
    Vec2 uv(0);
    const std::uint32_t index = patch_at(place, uv);
    if (index == no_index || !(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1)) return false;
    return trims_.untrimmed() || trims_.contains(model_.face_parameters(patches_[index].index, uv));
}

std::optional<SurfaceDerivatives> FaceSurface::evaluate(const Vec2& place, int order) const {
    if (!has_material(place)) return std::nullopt;
    return evaluate_beyond(place, order);
}

std::optional<Vec3> FaceSurface::normal(const SurfaceDerivatives& there) const {
    const Vec3 normal = there.du().cross(there.dv()).normalized() * sign_;
    return has_reliable_curvatures(there, normal) ? std::optional(normal) : std::nullopt;
}

Vec2 FaceSurface::place_of(const Vec2& parameters) const {
    const std::size_t column = span_of(begins_u_, parameters.x);
    const std::size_t row = span_of(begins_v_, parameters.y);
    Vec2 place(static_cast<double>(column), static_cast<double>(row));
    const std::uint32_t index = patch_in(column, row);
    if (index == no_index) return place;
    const Patch& patch = model_.patches[patches_[index].index];
    return place + Vec2(patch.map_u.to_patch(parameters.x), patch.map_v.to_patch(parameters.y));
}

std::vector<CollapsedSide> FaceSurface::collapsed_sides(double coincident) const {
    std::vector<CollapsedSide> found;
    const auto consider = [&](std::size_t column, std::size_t row, bool along_u, bool at_end) {
        const std::uint32_t index = patch_in(column, row);
        if (index == no_index) return;
        const BezierPatchView view = model_.patch(patches_[index].index);
        const auto n = static_cast<std::size_t>(view.degree_u);
        const auto m = static_cast<std::size_t>(view.degree_v), row_length = m + 1;
        const std::size_t first = !at_end ? 0 : along_u ? m : n * row_length;
        const std::size_t step = along_u ? row_length : 1, count = (along_u ? n : m) + 1;
        if (!is_point(patches_[index], first, step, count, coincident)) return;
        const Vec2 along = along_u ? Vec2(1, 0) : Vec2(0, 1);
        const Vec2 across = Vec2(1) - along;
        const Vec2 corner(static_cast<double>(column), static_cast<double>(row));
        found.push_back(at_end ? CollapsedSide{corner + across, along, across * -1.0}
                               : CollapsedSide{corner, along, across});
    };
    for (std::size_t column = 0; column < spans_u(); ++column)
        consider(column, 0, true, false), consider(column, spans_v() - 1, true, true);
    for (std::size_t row = 0; row < spans_v(); ++row)
        consider(0, row, false, false), consider(spans_u() - 1, row, false, true);
    return found;
}

std::vector<double> FaceSurface::span_lengths_u() const {
    std::vector<double> lengths(spans_u(), 0);
    for (std::size_t i = 0; i < table_.size(); ++i)
        if (const std::uint32_t p = table_[i]; p != no_index) {
            double& longest = lengths[i % spans_u()];
            longest = std::max(longest, extents(patches_[p], model_.patch(patches_[p].index)).x);
        }
    return lengths;
}

std::vector<double> FaceSurface::span_lengths_v() const {
    std::vector<double> lengths(spans_v(), 0);
    for (std::size_t i = 0; i < table_.size(); ++i)
        if (const std::uint32_t p = table_[i]; p != no_index) {
            double& longest = lengths[i / spans_u()];
            longest = std::max(longest, extents(patches_[p], model_.patch(patches_[p].index)).y);
        }
    return lengths;
}

} // namespace keiko
