#include "keiko/files/scan/scan_file.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/files/scan/scan_formats.h"

#include <cmath>
#include <functional>
#include <map>

namespace keiko {
namespace {

using PointReader = std::vector<Vec3> (*)(std::string_view bytes, const std::string& file);

/// The reader of a file by its ending; null for one that is no scan.
PointReader reader_of(const std::filesystem::path& path) {
    static const std::map<std::string, PointReader, std::less<>> readers{{".stl", stl_points},
                                                                         {".ply", ply_points},
                                                                         {".asc", column_points},
                                                                         {".xyz", column_points}};
    const auto found = readers.find(lower_case(path.extension().string()));
    return found == readers.end() ? nullptr : found->second;
}

void require_points(const std::vector<Vec3>& points, const std::string& file) {
    constexpr double largest = 1e9; // beyond which a double no longer resolves a nanometre
    if (points.empty()) throw Error(file, "", "holds no points");
    for (std::size_t i = 0; i < points.size(); ++i)
        for (unsigned k = 0; k < 3; ++k)
            if (!(std::abs(points[i][k]) <= largest))
                throw Error(file, "point " + std::to_string(i + 1),
                            "a coordinate must be from -1e9 to 1e9");
}

} // namespace

bool is_scan_file(const std::filesystem::path& path) {
    return reader_of(path) != nullptr;
}

std::vector<Vec3> read_scan(const std::filesystem::path& path, double millimetres) {
    const PointReader reader = reader_of(path);
    if (!reader) throw Error(path.string(), "", "is no scan: .stl, .ply, .asc or .xyz is needed");
    std::vector<Vec3> points = reader(read_file(path), path.string());
    require_points(points, path.string());
    for (Vec3& point : points) point *= millimetres;
    return points;
}

} // namespace keiko
