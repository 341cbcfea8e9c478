#pragma once

#include "keiko/light/tubes/c_plane.h"

#include <string>

namespace keiko {

class TomlTable;

/// The row of lamps of a [[c_plane]]. Throws Error with file, line and column.
CPlane c_plane_from(const TomlTable& table);
/// A [[c_plane]] that reads back as the same row.
std::string table_text(const CPlane& plane);

} // namespace keiko
