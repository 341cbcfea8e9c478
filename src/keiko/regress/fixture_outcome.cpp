#include "keiko/regress/fixture_outcome.h"

#include "keiko/workflow/draw_outcome.h"

#include <algorithm>

namespace keiko {
namespace {

const Film* film_in(const FixturePicture* picture) {
    return picture ? &picture->film : nullptr;
}

PictureOutcome picture_outcome(const PictureDifference& difference) {
    PictureOutcome picture{.view = difference.view, .problem = difference.problem};
    if (!difference.film) return picture;
    picture.take(*difference.film);
    return picture;
}

/// The checks that the fixture asks for, and those whose numbers are gone from it.
std::vector<std::string> checks_of(const FixtureSpec& spec, const FixtureDifference& difference) {
    std::vector<std::string> checks;
    if (spec.checks.shape) checks.emplace_back("shape");
    if (spec.checks.seams) checks.emplace_back("seams");
    if (spec.checks.lines) checks.emplace_back("lines");
    for (const MetricDifference& metric : difference.metrics)
        if (std::find(checks.begin(), checks.end(), metric.check) == checks.end())
            checks.push_back(metric.check);
    return checks;
}

} // namespace

FixtureOutcome fixture_outcome(const FixtureSpec& spec, const FixtureRecord* baseline,
                               const FixtureRecord& candidate) {
    FixtureOutcome outcome{.name = spec.name};
    if (!baseline) {
        outcome.state = FixtureState::missing;
        for (const FixturePicture& view : candidate.pictures) {
            outcome.pictures.push_back({.view = view.view});
            draw_outcome(outcome.pictures.back(), nullptr, &view.film, nullptr, outcome.pngs);
        }
        return outcome;
    }
    FixtureDifference difference = fixture_difference(*baseline, candidate, spec);
    if (!difference.within()) outcome.state = FixtureState::different;
    outcome.checks = checks_of(spec, difference);
    outcome.metrics_compared = difference.metrics_compared;
    outcome.metrics = std::move(difference.metrics);
    for (const PictureDifference& view : difference.pictures) {
        outcome.pictures.push_back(picture_outcome(view));
        if (!view.within())
            draw_outcome(outcome.pictures.back(), film_in(baseline->picture(view.view)),
                         film_in(candidate.picture(view.view)),
                         view.film ? &view.film->excess : nullptr, outcome.pngs);
    }
    return outcome;
}

} // namespace keiko
