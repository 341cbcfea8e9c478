#include "keiko/render/rectangle_trial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Of the error: how far light that parabolas may tell is off lines at the middles.
constexpr double most_bent = 8;
/// What parabolas are off by counts so often, since fewer places test them than lines.
constexpr double caution = 4;

/// Infinite where nothing is allowed, or what is wrong is no number.
double ratio(double wrong, double allowed) {
    if (wrong == 0) return 0;
    const double ratio = wrong / allowed;
    return ratio >= 0 ? ratio : infinite;
}

/// Puts lesser doubts, whose lights it tells, in place of those in the same lights.
Lights lessen(std::vector<Doubt>& doubts, const std::vector<Doubt>& others) {
    Lights lessened;
    auto doubt = doubts.begin();
    for (const Doubt& other : others) {
        while (doubt->light != other.light) ++doubt;
        if (other.error >= doubt->error) continue;
        *doubt = other;
        lessened.push_back(other.light);
    }
    return lessened;
}

bool is_whole(const SeenLight& seen) {
    return seen.share == 1 && seen.cap == 1 && seen.axis == IntervalSet::whole();
}

/// The normal of the plane that places lie in, which is that at the first; nothing where they do
/// not lie in one.
std::optional<Vec3> plane_of(std::span<const Vec3> places, const Vec3& normal) {
    constexpr double flat = 1e-9;
    for (const Vec3& place : places)
        if (std::abs(normal.dot(place - places[0])) > flat * (place - places[0]).length())
            return std::nullopt;
    return normal;
}

} // namespace

/// Lights that the middles rule out, for which the quarters ask as well, are not asked for at odd
/// places.
RectangleTrial::Told RectangleTrial::tell(const Rectangle& r, const LightPolynomial& known,
                                          const OpenLights& all, double& left) {
    const LightFit lines = LightFit::lines(grid_, r);
    const std::vector<Test> middles = middles_of(r, known, all);
    const Lights hidden = threatened(r, all.seen);
    const OpenLights open{without(all.lit, hidden), without(all.seen, hidden), all.linearly_seen};
    const bool may_bend = grid_.odd_places(r).size() > 1;
    const double most = may_bend ? most_bent * left : left;
    std::vector<Doubt> lit = doubts_in(open.lit);
    test(lines, middles, most, lit);
    const Lights smooth = within(lit, most);
    std::vector<Doubt> seen = doubts_in(without(open.seen, smooth));
    test_seen(r, middles, left, seen);
    const std::vector<Test> odd = odd_places_of(r, known, all, united(smooth, within(seen, left)));
    test(lines, odd, left, lit);
    Told told;
    if (may_bend) told.parabolas = lessen(lit, doubts_in_parabolas(r, middles, odd, smooth, left));
    told.lines = least_doubtful(std::move(lit), left);
    told.parabolas = common(told.parabolas, told.lines);
    std::vector<Doubt> others = doubts_in(without(common(open.seen, smooth), told.lines));
    test_seen(r, middles, left, others);
    seen.insert(seen.end(), others.begin(), others.end());
    test_seen(r, odd, left, seen);
    told.seen = least_doubtful(std::move(seen), left);
    told.lines = without(told.lines, told.parabolas);
    return told;
}

Lights RectangleTrial::threatened(const Rectangle& r, const Lights& lights) const {
    std::vector<Pixel> pixels;
    for (const Pixel& p : r.corners()) pixels.push_back(p);
    for (const Pixel& p : r.middles()) pixels.push_back(p);
    std::vector<Vec3> places;
    for (const Pixel& p : pixels) places.push_back(grid_.at(p.x, p.y)->place.position);
    const auto facing = plane_of(places, grid_.at(r.x0, r.y0)->place.normal);
    Lights threatened;
    for (const std::size_t light : lights) {
        const auto whole = [&](const Pixel& p) { return is_whole(lights_.seen(p.x, p.y, light)); };
        if (std::all_of(pixels.begin(), pixels.end(), whole) &&
            integrator_.may_come_between(places, integrator_.lights()[light], facing))
            threatened.push_back(light);
    }
    return threatened;
}

std::vector<RectangleTrial::Test> RectangleTrial::middles_of(const Rectangle& r,
                                                             const LightPolynomial& known,
                                                             const OpenLights& open) {
    for (const Pixel& p : r.corners()) find(open, grid_, p, lights_);
    std::vector<Test> middles;
    for (const Pixel& p : r.middles()) {
        find(open, grid_, p, lights_);
        middles.push_back({p, known.at(grid_.place(p)) + lights_.sum(p.x, p.y, open.lit)});
    }
    return middles;
}

/// Those that are not hopeful are not asked for, and taken linear there.
std::vector<RectangleTrial::Test> RectangleTrial::odd_places_of(const Rectangle& r,
                                                                const LightPolynomial& known,
                                                                const OpenLights& open,
                                                                const Lights& hopeful) {
    const LightFit lines = LightFit::lines(grid_, r);
    const Lights others = without(open.lit, hopeful);
    std::vector<Test> odd;
    for (const Pixel& p : grid_.odd_places(r)) {
        find({hopeful, common(hopeful, open.seen), open.linearly_seen}, grid_, p, lights_);
        const Vec2 place = grid_.place(p);
        odd.push_back({p, known.at(place) + lights_.sum(p.x, p.y, hopeful) +
                              lines.sum(lines.weights(place), sum_of(others))});
    }
    return odd;
}

std::vector<Doubt> RectangleTrial::doubts_in_parabolas(const Rectangle& r,
                                                       const std::vector<Test>& middles,
                                                       const std::vector<Test>& odd,
                                                       const Lights& lights, double left) const {
    const LightFit parabolas = LightFit::parabolas(grid_, r);
    std::vector<Doubt> doubts = doubts_in(lights);
    std::erase_if(doubts, [&](const Doubt& d) { return !sees_alike(r, odd, d.light); });
    test(parabolas, odd, left / caution, doubts);
    test(parabolas, middles, left / caution, doubts); // rows may have a line instead
    for (Doubt& doubt : doubts) doubt.error *= caution;
    return doubts;
}

/// Whether nothing tells of a kink: all corners and places of tests see alike.
bool RectangleTrial::sees_alike(const Rectangle& r, const std::vector<Test>& odd,
                                std::size_t light) const {
    const SeenLight& first = lights_.seen(r.x0, r.y0, light);
    const auto like_first = [&](const Pixel& p) {
        return alike(first, lights_.seen(p.x, p.y, light));
    };
    const auto corners = r.corners();
    const auto middles = r.middles();
    return std::all_of(corners.begin(), corners.end(), like_first) &&
           std::all_of(middles.begin(), middles.end(), like_first) &&
           std::all_of(odd.begin(), odd.end(), [&](const Test& t) { return like_first(t.place); });
}

/// Only those that are still within `most`.
void RectangleTrial::test(const LightFit& fit, const std::vector<Test>& tests, double most,
                          std::vector<Doubt>& doubts) const {
    for (const auto& [p, total] : tests) {
        const LightFit::Weights weights = fit.weights(grid_.place(p));
        for (Doubt& doubt : doubts)
            if (doubt.error <= most)
                doubt.add(share_of_error(p,
                                         fit.sum(weights, sum_of({&doubt.light, 1})) -
                                             lights_.light(p.x, p.y, doubt.light),
                                         total));
    }
}

/// Only those that are still within `most`.
void RectangleTrial::test_seen(const Rectangle& r, const std::vector<Test>& tests, double most,
                               std::vector<Doubt>& doubts) const {
    for (const auto& [p, total] : tests)
        for (Doubt& doubt : doubts)
            if (doubt.error <= most)
                doubt.add(share_of_error(p, wrong_if_seen_linearly({doubt.light, r}, p), total));
}

std::optional<SpotLight> RectangleTrial::wrong_if_seen_linearly(const LinearlySeen& linear,
                                                                const Pixel& p) const {
    const auto seen = seen_between_corners(lights_, grid_, linear, p);
    if (!seen) return std::nullopt;
    if (*seen == lights_.seen(p.x, p.y, linear.light)) return SpotLight();
    return lights_.if_seen(p.x, p.y, linear.light, *seen) - lights_.light(p.x, p.y, linear.light);
}

/// What is wrong at a place as a share of what may be, `total` being all light there.
double RectangleTrial::share_of_error(const Pixel& p, const std::optional<SpotLight>& wrong,
                                      const SpotLight& total) const {
    if (!wrong) return infinite;
    const LitSpot& spot = *grid_.at(p.x, p.y);
    const auto seen_of = [&](const SpotLight& light) {
        return spot.weight * integrator_.luminance(spot, light);
    };
    const Rgb off = seen_of(*wrong), seen = seen_[grid_.index(p.x, p.y)] + seen_of(total);
    if (std::isnan(off.r + off.g + off.b)) return infinite;
    const double most = std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)});
    return std::max(ratio(most, error_ * max_channel(seen)),
                    ratio(std::abs(wrong->incident), error_ * total.incident));
}

} // namespace keiko
