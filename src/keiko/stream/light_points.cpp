#include "keiko/stream/light_points.h"

#include "keiko/base/parallel.h"
#include "keiko/stream/hit_columns.h"
#include "keiko/stream/source_columns.h"
#include "keiko/stream/trace_rays.h"
#include "keiko/workflow/lit_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace keiko {
namespace {

/// Illuminance at the points of some lines: for each the lux from every source, then their sum.
struct Piece : RowPiece {
    std::vector<std::vector<double>> lux;
};

/// Name of the column of the light from surfaces.
constexpr std::string_view reflected_column = "reflected";

/// The columns of the sources, that of reflected light if the scene has a solution, and "sum".
std::vector<std::string> columns_of(const Scene& scene, const LightRig& rig) {
    std::vector<std::string> columns = source_columns(rig);
    if (scene.reflected) columns.emplace_back(reflected_column);
    columns.emplace_back("sum");
    return columns;
}

/// A lit scene with the names of its results.
struct LitColumns {
    const Scene& scene;
    std::vector<std::string> columns; ///< of the results
    LitScene lit;

    LitColumns(const Scene& of, const LightRig& by, const Job& job)
        : scene(of), columns(columns_of(of, by)), lit(of, by, TubeModel::automatic, job) {}
};

std::string field_of(std::size_t point) {
    return "points[" + std::to_string(point) + "]";
}

std::string in_lamp(const std::string& column) {
    return "lies in a lamp of " + column;
}

/// Ends the points before the first that lies in a lamp.
void end_before_lamps(ParsedRays& points, const RayLines& lines, const LitColumns& in) {
    for (std::size_t i = 0; i < points.rays.size(); ++i)
        if (const auto source = in.lit.source_around(points.rays[i].origin))
            return end_before(points, lines, i, in_lamp(in.columns[*source]), point_header);
}

std::vector<double> lux_at(const LitColumns& in, const Ray& point) {
    const Vec3 normal = point.direction.normalized();
    std::vector<Rgb> light = in.lit.direct(point.origin, normal);
    if (in.scene.reflected) light.push_back(in.lit.reflected(point.origin, normal));
    std::vector<double> lux;
    Rgb sum;
    for (const Rgb& lx : light) lux.push_back(luminance(lx)), sum += lx;
    lux.push_back(luminance(sum));
    return lux;
}

/// Reason to refuse a point with some light; nullopt if all of it has a limit.
std::optional<std::string> in_focus(const LitColumns& in, const std::vector<double>& lux) {
    const auto bright =
        std::find_if(lux.begin(), lux.end(), [](double x) { return std::isinf(x); });
    if (bright == lux.end()) return std::nullopt;
    return "lies in a focus of caustics of " + in.columns[bright - lux.begin()] +
           ", where the light has no limit";
}

std::string row_of(const std::vector<double>& lux) {
    std::string row;
    for (const double value : lux) {
        append_number(row, value);
        row += ',';
    }
    row.back() = '\n';
    return row;
}

void light(const LitColumns& in, Piece& piece) {
    ParsedRays parsed = rays_of(piece.lines, point_header);
    end_before_lamps(parsed, piece.lines, in);
    piece.rows.clear();
    piece.lux.clear();
    for (std::size_t i = 0; i < parsed.rays.size(); ++i) {
        std::vector<double> lux = lux_at(in, parsed.rays[i]);
        if (const auto reason = in_focus(in, lux))
            end_before(parsed, piece.lines, i, *reason, point_header);
        else
            piece.lux.push_back(std::move(lux));
    }
    piece.fault = std::move(parsed.fault);
}

void require_points(std::uint64_t count) {
    if (count == 0) throw Error("standard input", "", "holds no points");
}

void require_rig(const Scene& scene) {
    if (!scene.rig) throw Error("", "", "illuminance needs a scene file with a rig");
}

/// One column of all rows.
struct Column {
    double minimum = std::numeric_limits<double>::infinity(), maximum = -minimum, sum = 0;

    void add(double lux) {
        minimum = std::min(minimum, lux);
        maximum = std::max(maximum, lux);
        sum += lux;
    }
    std::string row(const std::string& name, std::uint64_t points) const {
        std::string text = name + ',' + std::to_string(points);
        const double mean = sum / static_cast<double>(points);
        for (const double value : {minimum, mean, maximum, minimum / mean}) {
            text += ',';
            if (std::isfinite(value)) append_number(text, value);
        }
        return text + '\n';
    }
};

} // namespace

std::uint64_t light_points(const Scene& scene, const ByteSource& points, const ByteSink& rows,
                           const Job& job) {
    require_rig(scene);
    const LitColumns in(scene, *scene.rig, job);
    std::string header;
    for (const std::string& column : in.columns) header += column + ',';
    header.back() = '\n';
    std::uint64_t count = 0;
    if (!rows(header)) return count;
    RayLineReader reader(points, point_header);
    const auto work = [&](Piece& piece) {
        light(in, piece);
        for (const std::vector<double>& lux : piece.lux) piece.rows += row_of(lux);
    };
    stream_rows<Piece>(reader, rows, job, work,
                       [&](const Piece& piece) { count += piece.lux.size(); });
    require_points(count);
    return count;
}

PointIlluminance illuminance_at(const Scene& scene, const LightRig& rig,
                                std::span<const Ray> points, const Job& job) {
    require_rays(points, "points", {}, point_header);
    const LitColumns in(scene, rig, job);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const auto source = in.lit.source_around(points[i].origin))
            throw FieldError(field_of(i), in_lamp(in.columns[*source]));
    const std::size_t width = in.columns.size();
    PointIlluminance found{in.columns, std::vector<double>(points.size() * width)};
    constexpr std::size_t chunk = 64;
    parallel_for((points.size() + chunk - 1) / chunk, job, "light", [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min(points.size(), (c + 1) * chunk); ++i) {
            const std::vector<double> row = lux_at(in, points[i]);
            if (const auto reason = in_focus(in, row)) throw FieldError(field_of(i), *reason);
            std::copy(row.begin(), row.end(), &found.lux[i * width]);
        }
    });
    return found;
}

std::uint64_t summarize_points(const Scene& scene, const ByteSource& points, const ByteSink& rows,
                               const Job& job) {
    require_rig(scene);
    const LitColumns in(scene, *scene.rig, job);
    const std::vector<std::string>& names = in.columns;
    std::vector<Column> columns(names.size());
    std::uint64_t count = 0;
    RayLineReader reader(points, point_header);
    stream_rows<Piece>(
        reader, rows, job, [&](Piece& piece) { light(in, piece); },
        [&](const Piece& piece) {
            count += piece.lux.size();
            for (const std::vector<double>& lux : piece.lux)
                for (std::size_t i = 0; i < lux.size(); ++i) columns[i].add(lux[i]);
        });
    require_points(count);
    std::string text = "source,points,minimum,mean,maximum,uniformity\n";
    for (std::size_t i = 0; i < names.size(); ++i) text += columns[i].row(names[i], count);
    rows(text);
    return count;
}

} // namespace keiko
