#include "keiko/render/shading/lamp_outline.h"

#include "keiko/light/areas/contour_view.h"

#include <algorithm>
#include <utility>

namespace keiko {
namespace {

/// Place between two parameters where a statement that holds at the first one, or not, changes.
template <class F>
double change_between(double low, double high, bool at_low, const F& holds) {
    constexpr int halvings = 24;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (holds(middle) == at_low ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// Parts of a stretch where a statement holds, as both ends and the middle tell.
template <class F>
std::vector<ParameterInterval> parts_where(const ParameterInterval& stretch, const F& holds) {
    constexpr double aside = 1e-3; // of the stretch, from what it ends at
    const double off = aside * stretch.length();
    double from = stretch.begin, before = from + off;
    bool was = holds(before);
    std::vector<ParameterInterval> parts;
    for (const double at : {(stretch.begin + stretch.end) / 2, stretch.end - off}) {
        if (holds(at) != was) {
            const double change = change_between(before, at, was, holds);
            if (was) parts.push_back({from, change});
            from = change, was = !was;
        }
        before = at;
    }
    if (was) parts.push_back({from, stretch.end});
    return parts;
}

} // namespace

LampOutline::LampOutline(const Vec3& point, ContourArcs arcs, LampSides shining,
                         SidesAlong sides_along, const Box3& box)
    : point_(point),
      arcs_(std::move(arcs)),
      shining_(shining),
      sides_along_(std::move(sides_along)),
      is_far_(ContourView::is_far(box, point)) {}

std::vector<LampOutline::Change> LampOutline::changes_along(const Segment& segment) const {
    const Vec3 from = segment.a - point_, to = segment.b - point_, plane = from.cross(to);
    std::vector<Change> changes;
    for (const ContourArc& arc : arcs_.all)
        for (const ArcRoot& root : arc.crossings(plane)) {
            const Vec3 way = arc.at(root.t);
            const double a = way.cross(to).dot(plane), b = from.cross(way).dot(plane);
            // Where the plane's height falls along the arc, the line enters what is left of it.
            if (a + b > 0) changes.push_back({b / (a + b), arc.left * (root.rises ? -1 : 1)});
        }
    std::sort(changes.begin(), changes.end(),
              [](const Change& i, const Change& k) { return i.at < k.at; });
    return changes;
}

SheetCount LampOutline::sheets_towards(const Vec3& place) const {
    SheetCount sheets;
    for (const bool outer : sides_along_(place - point_)) ++(outer ? sheets.front : sheets.back);
    return sheets;
}

bool LampOutline::shines_from(const Vec3& place) const {
    const std::vector<bool> sides = sides_along_(place - point_);
    return !sides.empty() && (shining_ == LampSides::both_sides || sides.front());
}

bool LampOutline::shines_from(const Vec3& place, const SheetCount& sheets) const {
    if (shining_ == LampSides::both_sides) return sheets.front + sheets.back > 0;
    if (sheets.front <= 0) return false;
    // Of a solid an inner side is behind an outer one, of sheets either may be.
    return shining_ == LampSides::of_solid || sheets.back <= 0 || shines_from(place);
}

IntervalSet LampOutline::intervals(const Segment& segment) const {
    std::vector<Change> changes = changes_along(segment);
    SheetCount first, left_over;
    if (!is_far_) {
        std::erase_if(changes, [](const Change& c) { return !(c.at > 0 && c.at < 1); });
        first = sheets_towards(segment.a);
        left_over = sheets_towards(segment.b) * -1;
    }
    left_over += first;
    for (const Change& change : changes) left_over += change.more;
    const bool is_sound = arcs_.are_complete && left_over == SheetCount{};
    return IntervalSet(bright_parts(segment, changes, first, is_sound)).complement();
}

std::vector<ParameterInterval> LampOutline::bright_parts(const Segment& segment,
                                                         std::vector<Change> changes,
                                                         SheetCount sheets, bool is_sound) const {
    constexpr double sliver = 3e-7; // of the line, where two pieces of an edge do not quite meet
    std::vector<ParameterInterval> bright;
    double from = 0;
    changes.push_back({1, {}});
    for (const Change& change : changes) {
        const double to = std::clamp(change.at, from, 1.0);
        if (to - from > sliver) {
            for (const ParameterInterval& part : bright_in(segment, {from, to}, sheets, is_sound))
                if (!bright.empty() && part.begin - bright.back().end <= sliver)
                    bright.back().end = part.end;
                else
                    bright.push_back(part);
            from = to;
        }
        sheets += change.more;
    }
    return bright;
}

std::vector<ParameterInterval> LampOutline::bright_in(const Segment& segment,
                                                      const ParameterInterval& stretch,
                                                      const SheetCount& sheets,
                                                      bool is_sound) const {
    const auto shines = [&](double t) {
        return is_sound ? shines_from(segment.at(t), sheets) : shines_from(segment.at(t));
    };
    const bool is_order_known = is_sound && !(sheets.front > 0 && sheets.back > 0);
    if (shining_ == LampSides::outer_side && !is_order_known) return parts_where(stretch, shines);
    const bool is_bright = shines((stretch.begin + stretch.end) / 2);
    return is_bright ? std::vector{stretch} : std::vector<ParameterInterval>();
}

std::vector<CriticalSlice> LampOutline::turns(const Prism& prism, const TurnRule& /*rule*/) const {
    const Vec3 along = (prism[0].b - prism[0].a).normalized();
    const Vec3 ahead = square_to((prism[0].a + prism[3].b) / 2 - point_, along).normalized();
    const Vec3 across = ahead.cross(along);
    std::vector<CriticalSlice> slices;
    const auto add = [&](const Vec3& way) {
        slices.push_back({.way = square_to(way, along).normalized()});
    };
    for (const ContourArc& arc : arcs_.all) {
        if (arc.turns_at_begin) add(arc.begin);
        if (arc.turns_at_end) add(arc.end);
        for (const ArcRoot& root : arc.extremes(ahead, across)) add(arc.at(root.t));
    }
    return slices;
}

} // namespace keiko
