#pragma once

#include "keiko/film/film.h"
#include "keiko/report/line_list.h"

namespace keiko {

/// The picture of one view of a list with its lines drawn over it and their crossings marked by
/// verdict, the worst of the list numbered by their rank.
Image with_lines(const Film& film, const LineList& list, std::size_t view);

} // namespace keiko
