#include "keiko/render/lighting/interpolation_test.h"

#include "keiko/render/lighting/light_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Limits of parabolas on squares of one size. The smaller these are the fewer places test them.
struct Bending {
    double most;    ///< of the error: largest deviation of the light at the middles from lines
    double caution; ///< factor of their deviation, since fewer places test them than lines
};
constexpr Bending bending_on_large{8, 4}, bending_on_small{2, 8};

const Bending& bending_on(const Rectangle& r) {
    constexpr int large = 6; // have more than one odd place
    return r.longest() >= large ? bending_on_large : bending_on_small;
}

/// Replaces larger errors of lights by smaller ones of the same lights, which it returns.
Lights lessen(std::vector<LightError>& errors, const std::vector<LightError>& others) {
    Lights lessened;
    auto doubt = errors.begin();
    for (const LightError& other : others) {
        while (doubt->light != other.light) ++doubt;
        if (other.error >= doubt->error) continue;
        *doubt = other;
        lessened.push_back(other.light);
    }
    return lessened;
}

} // namespace

/// Lights that the middles rule out, which the quarters compute as well, are not computed at odd
/// places.
InterpolationTest::Accepted InterpolationTest::tell(const Rectangle& r,
                                                    const LightPolynomial& known,
                                                    const UnresolvedLights& open, double& left) {
    const Interpolant lines = Interpolant::lines(grid_, r);
    const std::vector<Test> middles = middles_of(r, known, open);
    const bool may_bend = !grid_.odd_places(r).empty();
    const double most = may_bend ? bending_on(r).most * left : left;
    std::vector<LightError> lit = errors_in(open.lit);
    test(lines, middles, most, lit);
    const Lights smooth = within(lit, most);
    std::vector<LightError> seen = errors_in(without(open.seen, smooth));
    test_seen(r, middles, left, seen);
    const std::vector<Test> odd = odd_places_of(r, known, open, united(smooth, within(seen, left)));
    test(lines, odd, left, lit);
    Accepted told;
    if (may_bend) told.parabolas = lessen(lit, doubts_in_parabolas(r, middles, odd, smooth, left));
    told.lines = least_erroneous(std::move(lit), left);
    told.parabolas = common(told.parabolas, told.lines);
    std::vector<LightError> others = errors_in(without(common(open.seen, smooth), told.lines));
    test_seen(r, middles, left, others);
    seen.insert(seen.end(), others.begin(), others.end());
    test_seen(r, odd, left, seen);
    told.seen = least_erroneous(std::move(seen), left);
    told.lines = without(told.lines, told.parabolas);
    told.threatened = threatened(r, common(open.seen, told.all()));
    return told;
}

InterpolationTest::Test InterpolationTest::test_at(const Pixel& p, const DirectLight& total) const {
    return {p, ErrorBudget(integrator_, *grid_.at(p.x, p.y), seen_[grid_.index(p.x, p.y)], total,
                           error_)};
}

Lights InterpolationTest::threatened(const Rectangle& r, const Lights& lights) const {
    constexpr int two_apart = 4; // no place of such a square is farther from the next
    if (r.longest() <= two_apart) return {};
    return possibly_occluded_lights(integrator_, grid_, r,
                                    fully_visible_lights(lights_, r, lights));
}

std::vector<InterpolationTest::Test> InterpolationTest::middles_of(const Rectangle& r,
                                                                   const LightPolynomial& known,
                                                                   const UnresolvedLights& open) {
    for (const Pixel& p : r.corners()) find(open, grid_, p, lights_);
    std::vector<Test> middles;
    for (const Pixel& p : r.middles()) {
        find(open, grid_, p, lights_);
        middles.push_back(test_at(p, known.at(grid_.place(p)) + lights_.sum(p.x, p.y, open.lit)));
    }
    return middles;
}

/// Tests of odd places. Lights that are unlikely to pass are not computed, and taken as linear
/// there.
std::vector<InterpolationTest::Test> InterpolationTest::odd_places_of(const Rectangle& r,
                                                                      const LightPolynomial& known,
                                                                      const UnresolvedLights& open,
                                                                      const Lights& hopeful) {
    const Interpolant lines = Interpolant::lines(grid_, r);
    const Lights others = without(open.lit, hopeful);
    std::vector<Test> odd;
    for (const Pixel& p : grid_.odd_places(r)) {
        find({hopeful, common(hopeful, open.seen), open.linearly_seen}, grid_, p, lights_);
        const Vec2 place = grid_.place(p);
        odd.push_back(test_at(p, known.at(place) + lights_.sum(p.x, p.y, hopeful) +
                                     lines.sum(lines.weights(place), sum_of(others))));
    }
    return odd;
}

std::vector<LightError> InterpolationTest::doubts_in_parabolas(const Rectangle& r,
                                                               const std::vector<Test>& middles,
                                                               const std::vector<Test>& odd,
                                                               const Lights& lights,
                                                               double left) const {
    const Interpolant parabolas = Interpolant::parabolas(grid_, r);
    const double caution = bending_on(r).caution;
    std::vector<LightError> errors = errors_in(lights);
    std::erase_if(errors, [&](const LightError& d) { return !sees_alike(r, odd, d.light); });
    test(parabolas, odd, left / caution, errors);
    if (!parabolas.goes_through_middles()) test(parabolas, middles, left / caution, errors);
    for (LightError& doubt : errors) doubt.error *= caution;
    return errors;
}

/// True if nothing indicates a kink: all corners and places of tests have equal visibility.
bool InterpolationTest::sees_alike(const Rectangle& r, const std::vector<Test>& odd,
                                   std::size_t light) const {
    const LightVisibility& first = lights_.seen(r.x0, r.y0, light);
    const auto like_first = [&](const Pixel& p) {
        return alike(first, lights_.seen(p.x, p.y, light));
    };
    const auto corners = r.corners();
    const auto middles = r.middles();
    return std::all_of(corners.begin(), corners.end(), like_first) &&
           std::all_of(middles.begin(), middles.end(), like_first) &&
           std::all_of(odd.begin(), odd.end(), [&](const Test& t) { return like_first(t.place); });
}

/// Tests only lights that are still within `most`.
void InterpolationTest::test(const Interpolant& fit, const std::vector<Test>& tests, double most,
                             std::vector<LightError>& errors) const {
    for (const auto& [p, allowed] : tests) {
        const Interpolant::Weights weights = fit.weights(grid_.place(p));
        for (LightError& doubt : errors) {
            if (!(doubt.error <= most)) continue;
            const auto light = [&, this](const Pixel& at) -> const DirectLight& {
                return lights_.light(at.x, at.y, doubt.light);
            };
            doubt.add(allowed.used_by(fit.sum(weights, light) - light(p)));
        }
    }
}

/// Tests the visibility of only those lights that are still within `most`.
void InterpolationTest::test_seen(const Rectangle& r, const std::vector<Test>& tests, double most,
                                  std::vector<LightError>& errors) const {
    for (const auto& [p, allowed] : tests)
        for (LightError& doubt : errors) {
            if (!(doubt.error <= most)) continue;
            const auto wrong = wrong_if_seen_linearly({doubt.light, r}, p);
            doubt.add(wrong ? allowed.used_by(*wrong) : infinite);
        }
}

std::optional<DirectLight> InterpolationTest::wrong_if_seen_linearly(const LinearlySeen& linear,
                                                                     const Pixel& p) const {
    const auto seen = seen_between_corners(lights_, grid_, linear, p);
    if (!seen) return std::nullopt;
    return lights_.if_seen(p.x, p.y, linear.light, *seen) - lights_.light(p.x, p.y, linear.light);
}

} // namespace keiko
