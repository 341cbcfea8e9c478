#pragma once

#include "keiko/film/image_file.h"

#include <map>
#include <string>

namespace keiko {

/// Every buffer of a film side by side under the names a file gives them: R, G, B, A, then
/// "aov.channel". All buffers must have the size of the colour; throws Error otherwise.
NamedImage channels_of(const Film& film);

/// The film that channels_of took apart. Throws Error when R, G or B is missing; without A the
/// film has no alpha; an AOV counts when all of its channels are there.
Film film_of(const NamedImage& channels);

/// The same by layer: "color" (R, G, B, A), then the AOVs by name.
std::map<std::string, NamedImage> layers_of(const Film& film);

/// The film that layers_of took apart, or of some of its layers. Throws Error without "color", and
/// where the layers differ in size.
Film film_of(const std::map<std::string, NamedImage>& layers);

} // namespace keiko
