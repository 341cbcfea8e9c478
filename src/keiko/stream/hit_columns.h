#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/intersect/hit/hit.h"
#include "keiko/math/rgb.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Columns of a row of hits, in the order of `keiko trace --help`.
enum class HitColumn {
    t,         ///< in lengths of the ray's direction
    instance,  ///< index of the placed part, from 0
    face,      ///< number of the face, as in reports
    patch,     ///< index of the patch in the model, from 0
    u,         ///< patch parameter, 0 to 1
    v,         ///< patch parameter, 0 to 1
    x,         ///< mm, position
    y,         ///< mm, position
    z,         ///< mm, position
    nx,        ///< of the unit normal
    ny,        ///< of the unit normal
    nz,        ///< of the unit normal
    k1,        ///< 1/mm, the larger principal curvature; > 0 bends towards the normal
    k2,        ///< 1/mm, the smaller one
    bound,     ///< mm, certified distance to the exact intersection
    flags,     ///< flag_words()
    luminance, ///< cd/m2, along the ray
    r,         ///< cd/m2, along the ray
    g,         ///< cd/m2, along the ray
    b          ///< cd/m2, along the ray
};

/// Columns of a list "t,face,u": each once. Throws Error that names the fault.
std::vector<HitColumn> hit_columns(std::string_view list);

/// The name of the first of them that needs light.
std::optional<std::string> light_column(const std::vector<HitColumn>& columns);

/// "t,face,u", without line break.
std::string header_of(const std::vector<HitColumn>& columns);

/// Classification of a hit in words: "unique", "clipped", "tangential", or the last two together,
/// then "seam" if it is at one; with `|` between.
std::string flag_words(HitFlags flags);

/// Principal curvatures of the surface at a hit; no numbers close to a pole, and for a tracer
/// without second derivatives.
PrincipalCurvatures curvatures_of(const Hit& hit);

/// Appends the row of a hit and a line break. Numbers are the shortest that read back as the same
/// double; a field without a value, as for the curvatures of a pole, is empty.
void append_row(std::string& text, const std::vector<HitColumn>& columns, const Hit& hit,
                const Rgb& luminance);

/// Appends the row of a ray without a hit: empty fields and a line break.
void append_empty_row(std::string& text, const std::vector<HitColumn>& columns);

/// Appends the digits of a number, the fewest that read back as the same.
void append_number(std::string& text, std::uint64_t number);
/// Appends the digits of a number, the fewest that read back as the same.
void append_number(std::string& text, double number);

} // namespace keiko
