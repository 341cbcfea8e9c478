#include "keiko/fixture_outcome.h"

#include "keiko/film/difference_picture.h"
#include "keiko/film/image_file.h"

#include <cmath>

namespace keiko {
namespace {

const Film* film_in(const FixturePicture* picture) {
    return picture ? &picture->film : nullptr;
}

/// The exposure that shows a film best; the other film is shown by the same.
ToneMapping exposure_of(const Film& film) {
    return {.ev = std::log2(white_luminance(film) / saturation_luminance(0))};
}

/// Draws the pictures of a view and names them in its outcome.
void draw(PictureOutcome& picture, const Film* before, const Film* after, const Image* excess,
          FolderContent& pngs) {
    const Film& shown = before ? *before : *after;
    const ToneMapping exposure = exposure_of(shown);
    picture.width = shown.color.width, picture.height = shown.color.height;
    const auto add = [&](const char* what, const Image& display) {
        std::string name = picture.view + "-" + what + ".png";
        pngs[name] = encode_png(display);
        return name;
    };
    if (before) picture.before = add("before", tone_mapped(*before, exposure));
    if (after) picture.after = add("after", tone_mapped(*after, exposure));
    if (excess) picture.difference = add("difference", difference_picture(*excess));
}

PictureOutcome picture_outcome(const PictureDifference& difference) {
    PictureOutcome picture{.view = difference.view, .problem = difference.problem};
    if (!difference.film) return picture;
    picture.pixels = difference.film->pixels;
    picture.coverage_flips = difference.film->coverage_flips;
    picture.face_flips = difference.film->face_flips;
    picture.flips_within = difference.film->flips_within;
    picture.layers = difference.film->layers;
    return picture;
}

} // namespace

FixtureOutcome fixture_outcome(const FixtureSpec& spec, const FixtureRecord* baseline,
                               const FixtureRecord& candidate) {
    FixtureOutcome outcome{.name = spec.name};
    if (!baseline) {
        outcome.state = FixtureState::missing;
        for (const FixturePicture& view : candidate.pictures) {
            outcome.pictures.push_back({.view = view.view});
            draw(outcome.pictures.back(), nullptr, &view.film, nullptr, outcome.pngs);
        }
        return outcome;
    }
    FixtureDifference difference = fixture_difference(*baseline, candidate, spec);
    if (!difference.within()) outcome.state = FixtureState::different;
    outcome.metrics_compared = difference.metrics_compared;
    outcome.metrics = std::move(difference.metrics);
    for (const PictureDifference& view : difference.pictures) {
        outcome.pictures.push_back(picture_outcome(view));
        if (!view.within())
            draw(outcome.pictures.back(), film_in(baseline->picture(view.view)),
                 film_in(candidate.picture(view.view)), view.film ? &view.film->excess : nullptr,
                 outcome.pngs);
    }
    return outcome;
}

} // namespace keiko
