#pragma once

#include "keiko/base/output_folder.h"
#include "keiko/film/film.h"
#include "keiko/report/content/picture_outcome.h"

namespace keiko {

/// Draws the pictures of a view before and after under the same exposure, which suits the former
/// best, and their difference; names them in its outcome. nullptr: there is none.
void draw_outcome(PictureOutcome& picture, const Film* before, const Film* after,
                  const Image* excess, FolderContent& pngs);

} // namespace keiko
