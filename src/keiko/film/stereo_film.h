#pragma once

#include "keiko/film/film.h"

namespace keiko {

/// The pictures of two eyes in one, the left eye's on the left. Both have the same size and layers.
Film side_by_side(const Film& left, const Film& right);

/// The picture for glasses with a red filter before the left eye and a cyan one before the right:
/// the half-colour anaglyph [Wimmer2004]. Red is the left eye's luminance, green and blue are the
/// right eye's own. A pixel is covered as much as the better covered of both. No other layers.
Film anaglyph(const Film& left, const Film& right);

} // namespace keiko
