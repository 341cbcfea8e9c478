#include "keiko/stream/light_points.h"

#include "keiko/base/parallel.h"
#include "keiko/light/rig/prepared_rig.h"
#include "keiko/render/caustics/caustics.h"
#include "keiko/render/shading/direct_lighting.h"
#include "keiko/render/shading/glass_loss.h"
#include "keiko/stream/hit_columns.h"
#include "keiko/stream/source_columns.h"
#include "keiko/stream/trace_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

/// Illuminance at the points of some lines: for each the lux from every source, then their sum.
struct Piece : RowPiece {
    std::vector<std::vector<double>> lux;
};

/// The columns of the sources, and "sum".
std::vector<std::string> columns_of(const LightRig& rig) {
    std::vector<std::string> columns = source_columns(rig);
    columns.emplace_back("sum");
    return columns;
}

/// A scene with its rig, prepared once for all points.
struct LitScene {
    const Scene& scene;
    std::vector<std::string> columns; ///< of the results
    PreparedRig rig;
    GlassLoss glass, straight; ///< where caustics land, and without them
    std::optional<Caustics> caustics;

    LitScene(const Scene& lit, const LightRig& by, const Job& job)
        : scene(lit),
          columns(columns_of(by)),
          rig(by),
          glass(lit.seen(), lit.seen_materials(), lit.caustics.has_value()),
          straight(lit.seen(), lit.seen_materials()) {
        if (lit.caustics)
            caustics.emplace(lit.seen(), lit.seen_materials(), rig, *lit.caustics, job);
    }

    /// The first source that a point lies in a lamp of; nullopt: none.
    std::optional<std::size_t> source_around(const Vec3& point) const {
        for (std::size_t source = 0; source < rig.sources.size(); ++source)
            if (within_lamp(rig.sources[source], point)) return source;
        return std::nullopt;
    }
};

std::string in_lamp(const std::string& column) {
    return "lies in a lamp of " + column;
}

/// Ends the points before the first that lies in a lamp.
void end_before_lamps(ParsedRays& points, const RayLines& lines, const LitScene& lit) {
    for (std::size_t i = 0; i < points.rays.size(); ++i)
        if (const auto source = lit.source_around(points.rays[i].origin))
            return end_before(points, lines, i, in_lamp(lit.columns[*source]), point_header);
}

/// A place for which light is computed.
struct Place {
    Vec3 position;
    std::optional<Hit> hit{}; ///< if it is on a surface

    std::optional<Root> root() const { return hit ? std::optional(hit->root) : std::nullopt; }
};

/// The point of a surface that is nearest along the normal, if it is within the rounding of
/// coordinates with a few digits.
Place place_of(const Tracer& surfaces, const Vec3& point, const Vec3& normal) {
    constexpr double meant = 1e-3; // mm
    Ray across;
    across.origin = point;
    across.direction = normal;
    across.t_min = -meant, across.t_max = meant;
    Place place{point};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Hit& hit : surfaces.all(across))
        if (std::abs(hit.t) < nearest) nearest = std::abs(hit.t), place = {hit.position, hit};
    return place;
}

/// Takes from the light of each lamp what glass takes.
void dim_by_glass(const LitScene& in, const Place& place, std::span<const LightId> lights,
                  std::vector<Rgb>& lux) {
    // Caustics land on surfaces alone: a point in the air has the light that passes straight on.
    const GlassLoss& glass = place.hit ? in.glass : in.straight;
    for (std::size_t i = 0; i < lights.size(); ++i)
        lux[i] *= glass.left(in.rig.sources[lights[i].source], lights[i].lamp, place.position,
                             place.root());
}

/// Light of each source by way of mirrors and glass; empty without.
std::vector<Rgb> caustics_at(const LitScene& in, const Place& place, const Vec3& normal) {
    if (!in.caustics || !place.hit) return {};
    const Hit& hit = *place.hit;
    constexpr double near = 1e-3; // mm: beams about a point
    return in.caustics->at({hit.instance, hit.face, place.position, normal,
                            hit.dpdu.normalized() * near, hit.dpdv.normalized() * near});
}

std::vector<double> lux_at(const LitScene& in, const Ray& point) {
    const Scene& scene = in.scene;
    const Vec3 normal = point.direction.normalized();
    const Occluders* occluders = scene.occluders ? &*scene.occluders : nullptr;
    const DirectLighting lights(in.rig, occluders, occluders ? occluders->tracer() : scene.seen());
    const Place place = place_of(scene.seen(), point.origin, normal);
    constexpr TubeModel model = TubeModel::automatic;
    const PointLighting lit(in.rig, place.position, normal, model, lights.lights(),
                            lights.light_visibility(place.position, normal, place.root(),
                                                    lights.lights(), model, false));
    const std::vector<Rgb> caustics = caustics_at(in, place, normal);
    std::vector<Rgb> by_light = lit.illuminance_by_light();
    if (occluders && in.glass.any()) dim_by_glass(in, place, lights.lights(), by_light);
    std::vector<double> lux;
    Rgb sum;
    const auto add = [&](std::size_t source, std::span<const int> lamps, std::size_t first) {
        Rgb lx = caustics.empty() ? Rgb() : caustics[source];
        for (std::size_t i = 0; i < lamps.size(); ++i) lx += by_light[first + i];
        lux.push_back(luminance(lx));
        sum += lx;
    };
    each_source(lights.lights(), add);
    lux.push_back(luminance(sum));
    return lux;
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

void light(const LitScene& lit, Piece& piece) {
    ParsedRays parsed = rays_of(piece.lines, point_header);
    end_before_lamps(parsed, piece.lines, lit);
    piece.fault = std::move(parsed.fault);
    piece.rows.clear();
    piece.lux.clear();
    for (const Ray& point : parsed.rays) piece.lux.push_back(lux_at(lit, point));
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
    const LitScene lit(scene, *scene.rig, job);
    std::string header;
    for (const std::string& column : lit.columns) header += column + ',';
    header.back() = '\n';
    std::uint64_t count = 0;
    if (!rows(header)) return count;
    RayLineReader reader(points, point_header);
    const auto work = [&](Piece& piece) {
        light(lit, piece);
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
    const LitScene lit(scene, rig, job);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const auto source = lit.source_around(points[i].origin))
            throw FieldError("points[" + std::to_string(i) + "]", in_lamp(lit.columns[*source]));
    const std::size_t width = lit.columns.size();
    PointIlluminance found{lit.columns, std::vector<double>(points.size() * width)};
    constexpr std::size_t chunk = 64;
    parallel_for((points.size() + chunk - 1) / chunk, job, "light", [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min(points.size(), (c + 1) * chunk); ++i) {
            const std::vector<double> row = lux_at(lit, points[i]);
            std::copy(row.begin(), row.end(), &found.lux[i * width]);
        }
    });
    return found;
}

std::uint64_t summarize_points(const Scene& scene, const ByteSource& points, const ByteSink& rows,
                               const Job& job) {
    require_rig(scene);
    const LitScene lit(scene, *scene.rig, job);
    const std::vector<std::string>& names = lit.columns;
    std::vector<Column> columns(names.size());
    std::uint64_t count = 0;
    RayLineReader reader(points, point_header);
    stream_rows<Piece>(
        reader, rows, job, [&](Piece& piece) { light(lit, piece); },
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
