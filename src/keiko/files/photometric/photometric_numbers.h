#pragma once

#include "keiko/light/spotlight/intensity_table.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keiko {

/// The finite number that a word is, from -1e15 to 1e15; nullopt for any other word.
std::optional<double> photometric_number(std::string_view word);

/// A place in a luminaire file, for messages.
struct PhotometricPlace {
    const std::filesystem::path& source;
    std::size_t line;

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

} // namespace keiko
