#include "keiko/light_points.h"

#include "keiko/hit_columns.h"
#include "keiko/render/shadows.h"
#include "keiko/row_stream.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

struct Piece : RowPiece {
    std::uint64_t points = 0;
};

/// "c_plane.0,c_plane.1,spotlight.0,sum": kinds in the order of LightSource.
std::string header_of(const LightRig& rig) {
    constexpr std::array<std::string_view, std::variant_size_v<LightSource>> kinds{
        "c_plane", "spotlight", "luminaire", "sun"};
    std::array<int, kinds.size()> counts{};
    std::string header;
    for (const LightSource& source : rig.sources) {
        const std::size_t kind = source.index();
        header += std::string(kinds[kind]) + "." + std::to_string(counts[kind]++) + ",";
    }
    return header + "sum\n";
}

/// A place on the surfaces, to be lit.
struct Place {
    Vec3 position;
    std::optional<Root> root; ///< its own, if it is on one
};

/// The point of a surface that is nearest along the normal, if it is so near that it is meant:
/// coordinates are written with a few digits.
Place place_of(const Tracer& surfaces, const Vec3& point, const Vec3& normal) {
    constexpr double meant = 1e-3; // mm
    Ray across;
    across.origin = point;
    across.direction = normal;
    across.t_min = -meant, across.t_max = meant;
    Place place{point, {}};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Hit& hit : surfaces.all(across))
        if (std::abs(hit.t) < nearest) nearest = std::abs(hit.t), place = {hit.position, hit.root};
    return place;
}

void append_row(std::string& text, const Scene& scene, const Ray& point) {
    const Vec3 normal = point.direction.normalized();
    const ShadowedRig lights(*scene.rig, scene.occluders ? &*scene.occluders : nullptr,
                             scene.seen());
    const Place place = place_of(scene.seen(), point.origin, normal);
    const LitPoint lit = lights.at(place.position, normal, place.root);
    Rgb sum;
    for (std::size_t i = 0; i < scene.rig->sources.size(); ++i) {
        const Rgb lx = lit.from_source(i, TubeModel::automatic);
        append_number(text, luminance(lx));
        text += ',';
        sum += lx;
    }
    append_number(text, luminance(sum));
    text += '\n';
}

void work(const Scene& scene, Piece& piece) {
    ParsedRays parsed = rays_of(piece.lines, point_header);
    piece.fault = std::move(parsed.fault);
    piece.points = parsed.rays.size();
    piece.rows.clear();
    for (const Ray& point : parsed.rays) append_row(piece.rows, scene, point);
}

} // namespace

std::uint64_t light_points(const Scene& scene, const ByteSource& points, const ByteSink& rows,
                           const Job& job) {
    if (!scene.rig) throw Error("", "", "illuminance needs a scene file with a rig");
    std::uint64_t count = 0;
    if (!rows(header_of(*scene.rig))) return count;
    RayLineReader reader(points, point_header);
    stream_rows<Piece>(
        reader, rows, job, [&](Piece& piece) { work(scene, piece); },
        [&](const Piece& piece) { count += piece.points; });
    return count;
}

} // namespace keiko
