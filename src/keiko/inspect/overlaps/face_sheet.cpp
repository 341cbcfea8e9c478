#include "keiko/inspect/overlaps/face_sheet.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// The control points of a side of a net: at the begin or the end of u (`axis` 0) or v.
std::vector<Vec4> side_of(const BezierPatchView& net, unsigned axis, bool end) {
    std::vector<Vec4> side;
    const int fixed = end ? (axis == 0 ? net.degree_u : net.degree_v) : 0;
    const int last = axis == 0 ? net.degree_v : net.degree_u;
    for (int k = 0; k <= last; ++k)
        side.push_back(axis == 0 ? net.point(fixed, k) : net.point(k, fixed));
    return side;
}

/// Mean length of the control polygons along u (`axis` 0) or v, mm.
double mean_length(const BezierPatchView& net, unsigned axis) {
    const int along = axis == 0 ? net.degree_u : net.degree_v;
    const int across = axis == 0 ? net.degree_v : net.degree_u;
    const auto at = [&](int i, int j) {
        return euclidean(axis == 0 ? net.point(i, j) : net.point(j, i));
    };
    double sum = 0;
    for (int j = 0; j <= across; ++j)
        for (int i = 0; i < along; ++i) sum += (at(i + 1, j) - at(i, j)).length();
    return sum / (across + 1);
}

std::size_t index_of(const std::vector<double>& values, double value) {
    return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), value) -
                                    values.begin());
}

} // namespace

FaceSheet::FaceSheet(const SurfaceModel& model, const PlacedFace& face, double coincidence) {
    place_nets(model, face);
    list_lines(model, model.faces[face.face]);
    domain_ = {Vec2(0), Vec2(lines_[0].at.back(), lines_[1].at.back())};
    find_tips(coincidence);
    for (const unsigned axis : {0U, 1U})
        if (is_closed(axis, coincidence)) period_[axis] = domain_.upper[axis];
}

void FaceSheet::place_nets(const SurfaceModel& model, const PlacedFace& face) {
    const Face& of = model.faces[face.face];
    const Affine& placed = model.instances[face.instance].transform;
    Box3 box;
    for (std::uint32_t p = of.first_patch; p < of.first_patch + of.patch_count; ++p) {
        const BezierPatchView view = model.patch(p);
        nets_.push_back({p, view.degree_u, view.degree_v, {}});
        for (const Vec4& point : view.points) {
            nets_.back().points.push_back(placed.homogeneous(point));
            box.extend(euclidean(nets_.back().points.back()));
        }
    }
    origin_ = box.center();
    for (Net& net : nets_)
        for (Vec4& p : net.points) p -= Vec4(origin_.x * p.w, origin_.y * p.w, origin_.z * p.w, 0);
}

void FaceSheet::list_lines(const SurfaceModel& model, const Face& face) {
    const auto map_of = [&](const Patch& patch, unsigned axis) {
        return axis == 0 ? patch.map_u : patch.map_v;
    };
    for (const unsigned axis : {0U, 1U}) {
        std::vector<double>& knots = lines_[axis].knots;
        for (const Patch& patch : model.patches_of(face))
            for (const double knot : {map_of(patch, axis).begin, map_of(patch, axis).end})
                knots.push_back(knot);
        std::sort(knots.begin(), knots.end());
        knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
        std::vector<double> sums(knots.size() - 1), counts(knots.size() - 1);
        for (const Net& net : nets_) {
            const std::size_t span = index_of(knots, map_of(model.patches[net.patch], axis).begin);
            sums[span] += mean_length({net.degree_u, net.degree_v, net.points}, axis);
            ++counts[span];
        }
        lines_[axis].at.push_back(0);
        constexpr double least = 1e-9; // mm: spans have some width
        for (std::size_t k = 0; k < sums.size(); ++k)
            lines_[axis].at.push_back(lines_[axis].at.back() +
                                      std::max(least, sums[k] / std::max(counts[k], 1.0)));
    }
    grid_.assign(lines_[0].spans() * lines_[1].spans(), 0);
    for (std::size_t n = 0; n < nets_.size(); ++n) {
        const Patch& patch = model.patches[nets_[n].patch];
        grid_[index_of(lines_[0].knots, patch.map_u.begin) * lines_[1].spans() +
              index_of(lines_[1].knots, patch.map_v.begin)] = n + 1;
    }
}

void FaceSheet::find_tips(double coincidence) {
    for (const Net& net : nets_)
        for (const unsigned axis : {0U, 1U})
            for (const bool end : {false, true}) {
                const auto side = side_of({net.degree_u, net.degree_v, net.points}, axis, end);
                const Vec3 tip = euclidean(side.front());
                if (std::all_of(side.begin(), side.end(), [&](const Vec4& p) {
                        return (euclidean(p) - tip).length() <= coincidence;
                    }))
                    tips_.push_back(tip);
            }
}

/// True if the sides at the two ends have the same control points.
bool FaceSheet::is_closed(unsigned axis, double coincidence) const {
    const std::size_t last = lines_[axis].spans() - 1;
    for (std::size_t k = 0; k < lines_[1 - axis].spans(); ++k) {
        const Net* begin = axis == 0 ? net(0, k) : net(k, 0);
        const Net* end = axis == 0 ? net(last, k) : net(k, last);
        if (begin == nullptr || end == nullptr) return false;
        const auto a = side_of({begin->degree_u, begin->degree_v, begin->points}, axis, false);
        const auto b = side_of({end->degree_u, end->degree_v, end->points}, axis, true);
        if (a.size() != b.size()) return false;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (!((euclidean(a[i]) - euclidean(b[i])).length() <= coincidence)) return false;
    }
    return true;
}

const FaceSheet::Net* FaceSheet::net(std::size_t i, std::size_t j) const {
    const std::size_t number = grid_[i * lines_[1].spans() + j];
    return number == 0 ? nullptr : &nets_[number - 1];
}

std::size_t FaceSheet::span_of(unsigned axis, double at) const {
    const std::vector<double>& lines = lines_[axis].at;
    const auto above = std::upper_bound(lines.begin(), lines.end(), at);
    const auto span = std::max<std::ptrdiff_t>(above - lines.begin() - 1, 0);
    return std::min(static_cast<std::size_t>(span), lines_[axis].spans() - 1);
}

/// The coordinate in the domain that is `at` modulo the period.
double FaceSheet::within(unsigned axis, double at) const {
    if (!(period_[axis] > 0)) return at;
    return at - std::floor(at / period_[axis]) * period_[axis];
}

FaceSheet::Part FaceSheet::part(const Net& net, std::size_t i, std::size_t j,
                                const Box2& box) const {
    const Vec2 low(lines_[0].at[i], lines_[1].at[j]),
        high(lines_[0].at[i + 1], lines_[1].at[j + 1]);
    Part part{net.patch, {net.degree_u, net.degree_v, net.points}, unit_square, Vec2(0)};
    const Box2 cut = Box2{low, high}.intersection(box);
    part.extent = cut.extent();
    for (const unsigned axis : {0U, 1U}) {
        const double width = high[axis] - low[axis];
        part.uv.lower[axis] = std::clamp((cut.lower[axis] - low[axis]) / width, 0.0, 1.0);
        part.uv.upper[axis] = std::clamp((cut.upper[axis] - low[axis]) / width, 0.0, 1.0);
    }
    return part;
}

/// False for a box as narrow as the rounding of its coordinates.
bool FaceSheet::is_wide(const Box2& box) const {
    constexpr double rounding = 1e-12;
    return box.extent().x > rounding * domain_.upper.x &&
           box.extent().y > rounding * domain_.upper.y;
}

/// Adds the parts of a box between two values of s inside the domain; false if a patch is missing.
bool FaceSheet::add_column(const Box2& box, double s, double s_end,
                           std::vector<Part>& parts) const {
    const double t = within(1, box.lower.y), length = box.extent().y;
    const bool around = period_.y > 0 && t + length > domain_.upper.y;
    const Box2 pieces[] = {{Vec2(s, t), Vec2(s_end, around ? domain_.upper.y : t + length)},
                           {Vec2(s, 0), Vec2(s_end, around ? t + length - domain_.upper.y : 0)}};
    for (const Box2& piece : pieces) {
        if (!is_wide(piece)) continue;
        for (std::size_t i = span_of(0, piece.lower.x);
             i < lines_[0].spans() && lines_[0].at[i] < piece.upper.x; ++i)
            for (std::size_t j = span_of(1, piece.lower.y);
                 j < lines_[1].spans() && lines_[1].at[j] < piece.upper.y; ++j) {
                const Box2 span{Vec2(lines_[0].at[i], lines_[1].at[j]),
                                Vec2(lines_[0].at[i + 1], lines_[1].at[j + 1])};
                if (!is_wide(span.intersection(piece))) continue;
                if (net(i, j) == nullptr) return false;
                parts.push_back(part(*net(i, j), i, j, piece));
            }
    }
    return true;
}

std::optional<std::vector<FaceSheet::Part>> FaceSheet::parts(const Box2& box) const {
    for (const unsigned axis : {0U, 1U})
        if (period_[axis] > 0 && box.extent()[axis] > period_[axis]) return std::nullopt;
    std::vector<Part> parts;
    const double s = within(0, box.lower.x), length = box.extent().x;
    const bool around = period_.x > 0 && s + length > domain_.upper.x;
    if (!add_column(box, s, around ? domain_.upper.x : s + length, parts)) return std::nullopt;
    if (around && !add_column(box, 0, s + length - domain_.upper.x, parts)) return std::nullopt;
    return parts;
}

std::vector<FaceSheet::Part> FaceSheet::present_parts(const Box2& box) const {
    std::vector<Part> parts;
    for (std::size_t i = span_of(0, box.lower.x);
         i < lines_[0].spans() && lines_[0].at[i] < box.upper.x; ++i)
        for (std::size_t j = span_of(1, box.lower.y);
             j < lines_[1].spans() && lines_[1].at[j] < box.upper.y; ++j)
            if (net(i, j) != nullptr) parts.push_back(part(*net(i, j), i, j, box));
    return parts;
}

std::optional<FaceSheet::Part> FaceSheet::part_at(const Vec2& place) const {
    const Vec2 at(within(0, place.x), within(1, place.y));
    const std::size_t i = span_of(0, at.x), j = span_of(1, at.y);
    if (net(i, j) == nullptr) return std::nullopt;
    return part(*net(i, j), i, j, {at, at});
}

double FaceSheet::cut(const Box2& box, unsigned axis) const {
    const double middle = box.center()[axis];
    const std::vector<double>& lines = lines_[axis].at;
    const std::size_t span = span_of(axis, middle);
    double best = middle, off = box.extent()[axis] / 2;
    for (const double line : {lines[span], lines[span + 1]})
        if (line > box.lower[axis] && line < box.upper[axis] && std::abs(line - middle) < off)
            best = line, off = std::abs(line - middle);
    return best;
}

} // namespace keiko
