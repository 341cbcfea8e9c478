#pragma once

#include "keiko/film/film.h"
#include "keiko/report/content/line_list.h"
#include "keiko/workflow/find_lines.h"

namespace keiko {

/// The picture of one view of a list with its lines drawn over it and their crossings marked by
/// verdict, the worst of the list numbered by their rank.
Image with_lines(const Film& film, const LineList& list, std::size_t view);

/// The stripes of the lamps in one view of a list, with its lines drawn over them and their
/// crossings marked by verdict. The worst of the list are numbered as in the table.
Image lines_picture(const Scene& scene, const LinesOptions& options, const LineList& list,
                    std::size_t view, const Job& job = {});

} // namespace keiko
