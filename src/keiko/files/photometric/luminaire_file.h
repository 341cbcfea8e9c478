#pragma once

#include "keiko/light/spotlight/photometric_web.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace keiko {

/// Whether the name of a file ends in .ies or .ldt, in letters of any case.
bool is_luminaire_file(const std::filesystem::path& path);

/// Reads a luminaire file: EULUMDAT where its name ends in .ldt, else IES LM-63. Throws Error with
/// file, line and reason where it breaks its format.
PhotometricWeb read_luminaire(const std::filesystem::path& path);

/// Reads IES LM-63 of 1986 to 2019 [LM-63] (docs/theory/spotlights.md#luminaire-files). A lamp's
/// factors for a tilted luminaire (TILT=) are read, from a file beside `source` where the text
/// names one, and the one for no tilt applied.
PhotometricWeb parse_ies(std::string_view text, const std::filesystem::path& source);

/// Reads EULUMDAT [EULUMDAT] (docs/theory/spotlights.md#luminaire-files). Of several sets of lamps,
/// which are alternatives, the first counts.
PhotometricWeb parse_eulumdat(std::string_view text, const std::filesystem::path& source);

} // namespace keiko
