#pragma once

#include "keiko/film/image_file.h"

namespace keiko {

/// Every buffer of a film side by side under the names a file gives them: R, G, B, A, then
/// "aov.channel". All buffers must have the size of the colour; throws Error otherwise.
NamedImage channels_of(const Film& film);

/// The film that channels_of took apart. Throws Error when R, G or B is missing; without A the
/// film has no alpha; an AOV counts when all of its channels are there.
Film film_of(const NamedImage& channels);

} // namespace keiko
