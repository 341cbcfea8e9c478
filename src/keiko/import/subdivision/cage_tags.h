#pragma once

#include "keiko/import/subdivision/cage.h"
#include "keiko/import/subdivision/cage_lines.h"

namespace keiko::subdivision {

/// A line "t NAME INTEGERS/FLOATS/STRINGS values" of an OBJ file.
struct CageTag {
    std::string name;
    std::vector<long> integers;
    std::vector<double> floats;
    std::vector<std::string> strings;
    std::uint32_t line = 0;
};

/// Throws Error when the values are not as many as the tag says.
CageTag read_tag(const Statement& statement, const CageLines& lines);

/// Writes all tags into a cage whose vertices and faces are complete. Throws Error for a tag that
/// is unknown, names what is not there, or has too few values; a crease that is no edge of the
/// cage has no effect and is remarked upon.
void apply(const std::vector<CageTag>& tags, const CageLines& lines, Cage& cage);

} // namespace keiko::subdivision
