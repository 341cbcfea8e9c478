#include "keiko/inspect/combs/section_plane.h"

#include "keiko/base/error.h"
#include "keiko/inspect/basics/patch_fields.h"
#include "keiko/inspect/basics/visible_pieces.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace keiko {
namespace {

/// The finite number that the whole text states, without blanks; nullopt for any other text.
std::optional<double> number(std::string_view text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc() || rest != end || !std::isfinite(value)) return {};
    return value;
}

/// Unit normal named "x", "y", "z" or "A,B,C".
std::optional<Vec3> normal(std::string_view text) {
    Vec3 n(0);
    if (text.size() == 1 && text[0] >= 'x' && text[0] <= 'z') {
        n[static_cast<unsigned>(text[0] - 'x')] = 1;
        return n;
    }
    for (unsigned k = 0; k < 3; ++k) {
        const std::size_t comma = k < 2 ? text.find(',') : text.size();
        if (comma == text.npos) return {};
        const auto component = number(text.substr(0, comma));
        if (!component) return {};
        n[k] = *component;
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    if (!(n.length() > 0) || !std::isfinite(n.length())) return {};
    return n.normalized();
}

/// Number of boxes of a patch that are tested. A curve that crosses the plane takes some tens.
constexpr std::size_t most_boxes = 2000;

FieldCells cells_of(const BernsteinField& field) {
    LineCellOptions options;
    options.most_boxes = most_boxes;
    return field_cells(field, options);
}

/// The height over the plane times the weight, which has the same zeros.
BernsteinField height_field(const PlacedPatch& patch, const BezierPatchView& view,
                            const SectionPlane& plane, double tolerance) {
    const double height = plane.height - plane.normal.dot(patch.middle);
    std::vector<double> values;
    for (const Vec4& p : view.points)
        values.push_back(plane.normal.dot(Vec3(p.x, p.y, p.z)) - height * p.w);
    return {view.degree_u, view.degree_v, std::move(values), tolerance};
}

double largest_weight(const BezierPatchView& view) {
    double most = 0;
    for (const Vec4& p : view.points) most = std::max(most, p.w);
    return most;
}

std::vector<Vec2> doubtful_places(const FieldCells& found) {
    std::vector<Vec2> places;
    for (const Box2& box : found.blank) places.push_back(box.center());
    for (const LineCell& cell : found.cells)
        if (!cell.proved) places.push_back(cell.uv.center());
    return places;
}

/// Adds the fields of the curves along which a plane touches. The height has a double zero there,
/// and its derivative across the curve a simple one. That is the derivative by u if the height has
/// the larger second derivative along u, else by v.
void add_slopes(const BernsteinField& height, PlaneMeeting& meeting) {
    for (const bool by_u : {true, false}) {
        BernsteinField slope = height.derivative(by_u);
        (by_u ? meeting.bend_u : meeting.bend_v) = slope.derivative(by_u);
        std::vector<LineCell> cells = cells_of(slope).cells;
        meeting.fields.push_back({std::move(slope), std::move(cells), true, false, by_u});
    }
}

} // namespace

SectionPlane section_plane(const std::string& text) {
    const std::string_view all(text);
    const std::size_t sign = all.find('=');
    if (sign != all.npos) {
        const auto along = normal(all.substr(0, sign));
        const auto height = number(all.substr(sign + 1));
        if (along && height) return {text, *along, *height};
    }
    throw FieldError("section", "'" + text + "' is not x=MM, y=MM, z=MM or A,B,C=MM");
}

std::array<double, 2> heights(const SurfaceModel& model, const Vec3& along) {
    std::array<double, 2> reach{Box3::infinity, -Box3::infinity};
    const auto extend = [&](const Affine& placed, const Vec4& point) {
        const double height = along.dot(placed.point(euclidean(point)));
        reach = {std::min(reach[0], height), std::max(reach[1], height)};
    };
    for (const Instance& instance : model.instances) {
        const Part& part = model.parts[instance.part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f)
            for (std::uint32_t p = 0; p < model.faces[f].patch_count; ++p)
                for (const Vec4& point : model.patch(model.faces[f].first_patch + p).points)
                    extend(instance.transform, point);
    }
    return reach;
}

bool PlaneMeeting::steep_by_u(const Vec2& at) const {
    // Greater than 1, as a curve with equal slopes may run all along.
    constexpr double favour = 1.1;
    return favour * std::abs(bend_u(at)) >= std::abs(bend_v(at));
}

PlaneMeeting plane_meeting(const PlacedPatch& patch, const BezierPatchView& view,
                           const SectionPlane& plane, double tolerance) {
    PlaneMeeting meeting;
    meeting.tolerance = std::max(patch.rounding, tolerance * largest_weight(view));
    meeting.height = height_field(patch, view, plane, meeting.tolerance);
    if (!meeting.height.range().holds_zero()) return meeting;
    meeting.within = meeting.height.magnitude() <= meeting.tolerance;
    if (meeting.within) return meeting;
    BernsteinField inner = meeting.height;
    for (const BoundaryFactor& side : divide_sides(inner, 2 * meeting.tolerance))
        meeting.fields.push_back({iso_field(side.by_u, side.upper ? 1 : 0),
                                  {{unit_square, 0, true, side.by_u}},
                                  side.times > 1,
                                  true});
    FieldCells found = cells_of(inner);
    meeting.doubtful = doubtful_places(found);
    if (!meeting.doubtful.empty()) add_slopes(inner, meeting);
    meeting.fields.push_back({std::move(inner), std::move(found.cells), false, false});
    return meeting;
}

} // namespace keiko
