#pragma once

#include "keiko/base/export.h"
#include "keiko/light/spotlight/photometric_web.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// The finite number that a word is, from -1e15 to 1e15; nullopt for any other word.
std::optional<double> photometric_number(std::string_view word);

/// A place in a luminaire file, for messages.
struct PhotometricPlace {
    const std::filesystem::path& source; ///< the file, or what it is called in messages
    std::size_t line;                    ///< from 1

    /// Throws Error with file, line and reason.
    [[noreturn]] void fail(const std::string& reason) const;
    /// The photometric_number of a word; throws Error naming what it should have been.
    double number(std::string_view word, const char* wanted) const;
};

/// `degrees` if they ascend from `low` to at most `high`; else Error.
void require_ascending(const PhotometricPlace& place, const std::vector<double>& degrees,
                       double low, double high, const char* wanted);

/// Symmetry of the C planes of a table, by the first and the last; none where no symmetry completes
/// them to a full turn (docs/theory/spotlights.md#luminaire-files).
std::optional<PlaneSymmetry> symmetry_of_planes(const std::vector<double>& degrees);

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
