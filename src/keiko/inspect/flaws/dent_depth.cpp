#include "keiko/inspect/flaws/dent_depth.h"

#include "keiko/inspect/flaws/reference_form.h"

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
                                FormKind kind, FormDomain domain) {
    std::vector<ReferenceForm> found;
    for (const double share : dent_reaches)
        if (const auto base = ReferenceForm::fit(heights, share * half_window, kind, domain))
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
std::optional<DentForm> dent_form(std::span<const FormHeight> heights, double half_window,
                                  FormDomain domain = FormDomain::disc) {
    const std::vector<ReferenceForm> flat = fits(heights, half_window, FormKind::flat, domain);
    const std::vector<ReferenceForm> bent = fits(heights, half_window, FormKind::bent, domain);
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
    if (!s) return std::nullopt;
    return faces.frame(at, s->du().length2() > s->dv().length2() ? s->du() : s->dv());
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

/// The surface along the plane's x axis, in equal steps as far as the widest reach.
std::vector<FormHeight> heights_along(const FaceAdjacency& faces, const SheetPoint& at,
                                      const TangentFrame& from, double reach) {
    constexpr int steps = 48; // to either side
    std::vector<FormHeight> heights;
    for (const double side : {-1.0, 1.0}) {
        SheetPoint last = at;
        for (int k = 0; k < steps; ++k) {
            const double x = side * dent_reaches.back() * reach * (k + 0.5) / steps;
            const auto next = faces.moved(from, last, Vec2(x, 0));
            if (!next) break;
            last = *next;
            heights.push_back({x, 0, from.local(faces.evaluate(last, 0)->position()).z, 1});
        }
    }
    return heights;
}

/// A dent by the form along one line.
std::optional<DentDepth> depth_along(const FaceAdjacency& faces, const SheetPoint& at,
                                     const Vec3& ruling, double reach) {
    const auto from = faces.frame(at, ruling);
    if (!from) return std::nullopt;
    const std::vector<FormHeight> heights = heights_along(faces, at, *from, reach);
    const auto form = dent_form(heights, reach, FormDomain::line);
    if (!form) return std::nullopt;
    const auto ahead =
        std::count_if(heights.begin(), heights.end(), [](const FormHeight& h) { return h.x > 0; });
    const auto fewest = static_cast<std::ptrdiff_t>(heights.size() / 10);
    const bool one_sided =
        ahead < fewest || static_cast<std::ptrdiff_t>(heights.size()) - ahead < fewest;
    const double offset = -form->base.at_origin();
    return DentDepth{offset,    form->bound,
                     at,        from->origin,
                     one_sided, is_alone(heights, form->base, std::abs(offset) / 2)};
}

/// Climbs to the deepest place by the forms along lines in one direction.
std::optional<DentDepth> deepest_along(const FaceAdjacency& faces, const SheetPoint& begin,
                                       const Vec3& ruling, double reach) {
    auto best = depth_along(faces, begin, ruling, reach);
    constexpr int halvings = 6, most_rounds = 40;
    double step = reach / 20;
    for (int halved = 0, round = 0; best && halved < halvings && round < most_rounds; ++round) {
        const auto from = faces.frame(best->at, ruling);
        if (!from) break;
        bool moved = false;
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            const auto next = faces.moved(*from, best->at, way * step);
            const auto there = next ? depth_along(faces, *next, ruling, reach) : std::nullopt;
            if (!there || there->bound > 2 * best->bound ||
                there->offset * best->offset <= best->offset * best->offset)
                continue;
            best = there, moved = true;
            break;
        }
        if (!moved) step /= 2, ++halved;
    }
    return best;
}

/// Unit direction in a plane in which the surface around its origin bends least: the phase of the
/// second harmonic of its curvature around.
Vec2 straightest(std::span<const FormHeight> heights) {
    double even = 0, odd = 0, mean = 0;
    for (const FormHeight& h : heights) {
        const double squared = h.x * h.x + h.y * h.y, bend = h.z / squared;
        even += bend * (h.x * h.x - h.y * h.y) / squared;
        odd += bend * 2 * h.x * h.y / squared, mean += bend;
    }
    const double turned = mean > 0 ? std::numbers::pi / 2 : 0; // to where it bends less
    const double angle = std::atan2(odd, even) / 2 + turned;
    return {std::cos(angle), std::sin(angle)};
}

/// True if the surface turns away from its plane on both sides of a direction within `reach`, as a
/// tube does on either side of its ruling.
bool turns_away(std::span<const FormHeight> heights, const Vec2& along, double reach) {
    const FormHeight *left = nullptr, *right = nullptr;
    const auto off = [&](const FormHeight& h) { return along.cross(Vec2(h.x, h.y)); };
    for (const FormHeight& h : heights) {
        if (!left || off(h) > off(*left)) left = &h;
        if (!right || off(h) < off(*right)) right = &h;
    }
    if (!left) return false;
    constexpr double steep = 0.3;
    const auto away = [&](const FormHeight& h) {
        const double width = std::abs(off(h));
        return width < reach && std::abs(h.z) > steep * width;
    };
    return away(*left) && away(*right);
}

/// Unit direction of the ruling of a tube beside a dent, by its principal directions beyond the
/// dent; nullopt if the surface does not turn away on both sides.
std::optional<Vec3> ruling_of_tube(const FaceAdjacency& faces, const SheetPoint& at,
                                   const TangentFrame& from, std::span<const FormHeight> heights,
                                   double reach) {
    const Vec2 along = straightest(heights);
    if (!turns_away(heights, along, reach)) return std::nullopt;
    constexpr double beyond = 0.6; // of half a window: dents are narrower
    Vec3 ruling(0);
    for (const double side : {-1.0, 1.0}) {
        const auto place = faces.moved(from, at, along * (side * beyond * reach));
        const auto s = place ? faces.evaluate(*place, 2) : std::nullopt;
        const auto frame =
            s ? faces.frame(*place, *s, from.x * along.x + from.y * along.y) : std::nullopt;
        const auto bend = frame ? faces.bend(*place, *s, *frame, reach) : std::nullopt;
        if (!bend) continue;
        // The principal direction next to x, which is about the ruling.
        const double angle = std::atan(2 * bend->xy / (bend->xx - bend->yy)) / 2;
        ruling += frame->x * std::cos(angle) + frame->y * std::sin(angle);
    }
    if (!(ruling.length() > 0)) return std::nullopt;
    return ruling.normalized();
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
        if (const auto ruling = ruling_of_tube(faces, at, *from, heights, reach)) {
            auto on_line = deepest_along(faces, at, *ruling, reach);
            if (on_line && on_line->bound < std::abs(on_line->offset)) return on_line;
        }
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
