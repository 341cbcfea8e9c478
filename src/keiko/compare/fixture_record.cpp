#include "keiko/compare/fixture_record.h"

#include "keiko/base/error.h"

#include <algorithm>

namespace keiko {
namespace {

/// "depth, normal"
std::string layer_list(const Film& film) {
    std::string text = "color";
    for (const auto& [aov, image] : film.aovs) text += ", " + std::string(name_of(aov));
    return text;
}

PictureDifference picture_difference(const std::string& view, const FixturePicture* before,
                                     const FixturePicture* after, const FilmTolerance& tolerance) {
    PictureDifference found{view, "", {}};
    if (!before || !after) {
        found.problem = before ? "is no view of the fixture any more" : "is not in the baseline";
        return found;
    }
    const std::string layers_before = layer_list(before->film),
                      layers_after = layer_list(after->film);
    if (layers_before != layers_after)
        found.problem = "has the layers " + layers_after + "; the baseline has " + layers_before;
    try {
        found.film = film_difference(before->film, after->film, tolerance);
    } catch (const Error& error) {
        found.problem = error.reason();
    }
    if (!found.problem.empty()) found.film.reset();
    return found;
}

} // namespace

const FixtureEye* FixtureSetup::eye(const std::string& asked, int width, int height) const {
    const auto found = std::find_if(eyes.begin(), eyes.end(), [&](const FixtureEye& e) {
        return e.asked == asked && e.camera.width == width && e.camera.height == height;
    });
    return found == eyes.end() ? nullptr : &*found;
}

const FixturePicture* FixtureRecord::picture(const std::string& view) const {
    const auto found = std::find_if(pictures.begin(), pictures.end(),
                                    [&](const FixturePicture& p) { return p.view == view; });
    return found == pictures.end() ? nullptr : &*found;
}

bool FixtureDifference::within() const {
    return metrics.empty() &&
           std::all_of(pictures.begin(), pictures.end(),
                       [](const PictureDifference& picture) { return picture.within(); });
}

FixtureDifference fixture_difference(const FixtureRecord& before, const FixtureRecord& after,
                                     const FixtureSpec& spec) {
    FixtureDifference difference;
    difference.metrics = metric_differences(before.metrics, after.metrics, spec.metric_tolerance);
    const auto gone = std::count_if(difference.metrics.begin(), difference.metrics.end(),
                                    [](const MetricDifference& metric) { return !metric.after; });
    difference.metrics_compared = after.metrics.size() + static_cast<std::size_t>(gone);
    for (const FixturePicture& picture : after.pictures)
        difference.pictures.push_back(picture_difference(picture.view, before.picture(picture.view),
                                                         &picture, spec.film_tolerance));
    for (const FixturePicture& picture : before.pictures)
        if (!after.picture(picture.view))
            difference.pictures.push_back(
                picture_difference(picture.view, &picture, nullptr, spec.film_tolerance));
    return difference;
}

} // namespace keiko
