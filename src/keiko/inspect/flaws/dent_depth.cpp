#include "keiko/inspect/flaws/dent_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace keiko {
namespace {

/// The form under a dent, and the accuracy to which its surroundings determine it.
struct DentForm {
    ReferenceForm base;
    double bound = 0; ///< mm: estimated error of its height at the origin
};

/// Radii around a dent within which its form is fitted, as shares of half a window's width: the
/// roots of 8, 12, 19 and 31 rings of samples out of 12.
constexpr std::array<double, 4> dent_reaches{0.8165, 1, 1.2583, 1.6073};

std::vector<ReferenceForm> fits(std::span<const FormHeight> heights, double half_window,
                                BaseKind kind) {
    std::vector<ReferenceForm> found;
    for (const double share : dent_reaches)
        if (const auto base = ReferenceForm::fit(heights, share * half_window, kind))
            found.push_back(*base);
    return found;
}

/// Error bound of a fit among those of its kind by ascending reach, from its narrower neighbour and
/// the fits of the other kind.
double bound_of(std::span<const ReferenceForm> kind, std::size_t index,
                std::span<const ReferenceForm> other_kind) {
    const double here = kind[index].at_origin();
    double change = std::abs(here - kind[index - 1].at_origin());
    const auto consider = [&](const ReferenceForm& base) {
        change = std::max(change, std::abs(here - base.at_origin()) - base.origin_bound());
    };
    for (const ReferenceForm& wider : kind.subspan(index + 1)) consider(wider);
    for (const ReferenceForm& other : other_kind)
        if (other.reach() >= kind[index].reach()) consider(other);
    return change + kind[index].origin_bound();
}

/// Fits the form of either kind to heights within each of the reaches (`half_window` mm times the
/// shares above), and takes the fit with the least bound. A dent that fills most of the narrow
/// reaches does not fill the wide ones; other features around it lie in the wide ones alone. The
/// bound is the change of the height at the origin from the next narrower fit, or its distance from
/// the bounds of a wider one, with the effect of the scatter about the fit. It is nullopt if no two
/// of a kind can be fitted.
std::optional<DentForm> dent_form(std::span<const FormHeight> heights, double half_window) {
    const std::vector<ReferenceForm> flat = fits(heights, half_window, BaseKind::flat);
    const std::vector<ReferenceForm> bent = fits(heights, half_window, BaseKind::bent);
    std::optional<DentForm> best;
    const auto consider = [&](const std::vector<ReferenceForm>& kind,
                              const std::vector<ReferenceForm>& other) {
        for (std::size_t i = 1; i < kind.size(); ++i) {
            const double bound = bound_of(kind, i, other);
            if (!best || bound < best->bound) best = DentForm{kind[i], bound};
        }
    };
    consider(flat, bent), consider(bent, flat);
    return best;
}

constexpr int directions = 32;
constexpr int rings = 12;     ///< within half a window
constexpr int all_rings = 31; ///< within the widest reach

std::optional<TangentFrame> outlook(const FaceAdjacency& faces, const SheetPoint& at) {
    const auto s = faces.evaluate(at, 1);
    return s ? faces.frame(at, s->du()) : std::nullopt;
}

/// The surface around a place by samples in all directions that represent equal areas. Each
/// straight trace ends where the material does.
std::vector<FormHeight> heights_around(const FaceAdjacency& faces, const SheetPoint& at,
                                       const TangentFrame& from, double reach) {
    std::vector<FormHeight> heights;
    for (int d = 0; d < directions; ++d) {
        const double angle = 2 * std::numbers::pi * (d + 0.5) / directions;
        SheetPoint last = at;
        for (int r = 0; r < all_rings; ++r) {
            const double radius = reach * std::sqrt((r + 0.5) / rings);
            const Vec2 to(radius * std::cos(angle), radius * std::sin(angle));
            const auto next = faces.moved(from, last, to);
            if (!next) break;
            last = *next;
            heights.push_back({to.x, to.y, from.local(faces.evaluate(last, 0)->position()).z, 1});
        }
    }
    return heights;
}

/// The part of heights within half a window.
std::vector<FormHeight> within(std::span<const FormHeight> heights, double reach) {
    std::vector<FormHeight> near;
    for (const FormHeight& h : heights)
        if (std::hypot(h.x, h.y) < reach) near.push_back(h);
    return near;
}

/// True if less than a twentieth of the samples lie in some quarter.
bool is_one_sided(std::span<const FormHeight> heights) {
    std::array<std::size_t, 4> quarters{};
    for (const FormHeight& h : heights) ++quarters[(h.x > 0 ? 1u : 0u) + (h.y > 0 ? 2u : 0u)];
    return std::any_of(quarters.begin(), quarters.end(),
                       [&](std::size_t count) { return count * 20 < heights.size(); });
}

/// True if less than a quarter of the samples deviate from the form by more than `far`.
bool is_alone(std::span<const FormHeight> heights, const ReferenceForm& under, double far) {
    const auto off = std::count_if(heights.begin(), heights.end(), [&](const FormHeight& h) {
        return std::abs(under.offset(h)) > far;
    });
    return static_cast<std::size_t>(off) * 4 < heights.size();
}

/// The place of the largest deviation, by steps in the plane that are halved when no step increases
/// it.
SheetPoint furthest(const FaceAdjacency& faces, const SheetPoint& begin, const TangentFrame& from,
                    const ReferenceForm& under, double reach) {
    SheetPoint at = begin;
    Vec2 here(0);
    const double side = under.at_origin() > 0 ? -1 : 1;
    double best = -under.at_origin() * side, step = reach / 10;
    constexpr int halvings = 8;
    for (int halved = 0; halved < halvings;) {
        bool moved = false;
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            const Vec2 to = here + way * step;
            if (!(to.length2() < reach * reach)) continue;
            const auto next = faces.moved(from, at, to);
            if (!next) continue;
            const double height = from.local(faces.evaluate(*next, 0)->position()).z;
            const double there = under.offset({to.x, to.y, height, 1}) * side;
            if (there > best) best = there, here = to, at = *next, moved = true;
        }
        if (!moved) step /= 2, ++halved;
    }
    return at;
}

} // namespace

std::optional<DentDepth> dent_depth(const FaceAdjacency& faces, const SheetPoint& begin,
                                    double reach) {
    constexpr std::size_t fewest = directions * rings / 8; // half of a corner's quarter
    constexpr int rounds = 3;
    SheetPoint at = begin;
    for (int i = 0;; ++i) {
        const auto from = outlook(faces, at);
        if (!from) return std::nullopt;
        const std::vector<FormHeight> heights = heights_around(faces, at, *from, reach);
        const std::vector<FormHeight> near = within(heights, reach);
        if (near.size() < fewest) return std::nullopt;
        const auto form = dent_form(heights, reach);
        if (!form) return std::nullopt;
        if (i < rounds) {
            at = furthest(faces, at, *from, form->base, reach);
            continue;
        }
        const double offset = -form->base.at_origin();
        return DentDepth{
            offset,       form->bound,        at,
            from->origin, is_one_sided(near), is_alone(near, form->base, std::abs(offset) / 2)};
    }
}

} // namespace keiko
