#include "keiko/workflow/draw_outcome.h"

#include "keiko/film/image_difference.h"
#include "keiko/film/image_file.h"

#include <cmath>

namespace keiko {
namespace {

/// The exposure that shows a film best.
ToneMapping exposure_of(const Film& film) {
    return {.ev = std::log2(white_luminance(film) / saturation_luminance(0))};
}

} // namespace

void draw_outcome(PictureOutcome& picture, const Film* before, const Film* after,
                  const Image* excess, FolderContent& pngs) {
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

} // namespace keiko
