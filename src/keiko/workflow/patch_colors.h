#pragma once

#include "keiko/workflow/film_sight.h"

#include <map>

namespace keiko {

/// Display colours of the patches that a film with Aov::patch shows, by their index. Neighbours in
/// the picture differ as far as there are colours. A patch has the colour of its index unless an
/// earlier neighbour has it, so that it looks alike from most views.
std::map<int, Rgb> patch_colors(const FilmSight& sight);

} // namespace keiko
