#pragma once

#include "keiko/light/spotlight/photometric_web.h"

#include <filesystem>
#include <vector>

namespace keiko {

/// An intensity table as files tell it: angles in degrees, and a column of values over theta for
/// each phi.
struct IntensityColumns {
    std::vector<double> theta;               ///< degrees from the axis
    std::vector<double> phi{0};              ///< degrees about the axis, one a column
    std::vector<std::vector<double>> values; ///< by phi, then theta; of the file's unit
};

/// Why the columns make no table; "" when they do: theta must ascend from 0 to at most 180, phi
/// from 0 to 90, 180 or at most 360, and no value may be negative.
std::string table_fault(const IntensityColumns& columns);

/// The table, its poles replaced by their mean over phi (docs/theory/spotlights.md#tables),
/// unfolded from the planes up to 90 or 180 degrees by mirroring. Requires that there is no fault.
IntensityTable intensity_table(IntensityColumns columns, TableInterpolation interpolation);

/// Reads a CSV file: `theta` and the angles phi in the first row, an angle theta and its values in
/// each other row; empty rows and what follows a # are skipped. Throws Error with file, line and
/// reason.
IntensityColumns read_intensity_csv(const std::filesystem::path& path);

} // namespace keiko
