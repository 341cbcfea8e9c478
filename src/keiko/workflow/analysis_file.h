#pragma once

#include "keiko/base/export.h"
#include "keiko/scene/analysis.h"

#include <filesystem>
#include <string>

namespace KEIKO_API keiko {

/// Reads an analysis (keiko-analysis/1, docs/file-formats.md). Files that its rig names are
/// relative to its own folder. Throws Error with file, field and reason.
Analysis read_analysis(const std::filesystem::path& file);

/// Parses the text of an analysis from elsewhere; `source` is the file name for messages. Throws
/// Error as read_analysis, and for a rig that names a file.
Analysis parse_analysis_alone(const std::string& text, const std::string& source);

/// Throws Error with field and reason for an analysis that no file may hold: views that share a
/// name, a look or a section that there is not, an empty note.
void require_valid(const Analysis& analysis);

/// The text of an analysis, which reads back as the same. Files of luminaires are named relative to
/// `folder`, if there is one.
std::string analysis_text(const Analysis& analysis, const std::filesystem::path& folder = {});

} // namespace keiko
