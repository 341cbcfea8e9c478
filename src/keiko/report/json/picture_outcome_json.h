#pragma once

#include "keiko/report/content/picture_outcome.h"
#include "keiko/report/markup/json_text.h"

namespace keiko {

/// view, problem, pixels, coverage_flips, face_flips, flips_within, layers [{layer, beyond,
/// largest, excess, root_mean_square, x, y, within}], width, height, before, after, difference.
Json picture_outcome_json(const PictureOutcome& picture);
/// Inverse of picture_outcome_json. Throws Json::exception.
PictureOutcome picture_outcome_from(const Json& json);

} // namespace keiko
