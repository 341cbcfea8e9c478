#include "keiko/light_points.h"

#include "keiko/base/parallel.h"
#include "keiko/hit_columns.h"
#include "keiko/render/shadows.h"

#include <array>

namespace keiko {
namespace {

/// A piece of the stream on its way from lines to rows.
struct Piece {
    RayLines lines;
    std::string rows;
    std::optional<Error> fault;
    std::uint64_t points = 0;
};

/// "c_plane.0,c_plane.1,spotlight.0,sum": kinds in the order of LightSource.
std::string header_of(const LightRig& rig) {
    constexpr std::array<std::string_view, std::variant_size_v<LightSource>> kinds{
        "c_plane", "spotlight", "sun"};
    std::array<int, kinds.size()> counts{};
    std::string header;
    for (const LightSource& source : rig.sources) {
        const std::size_t kind = source.index();
        header += std::string(kinds[kind]) + "." + std::to_string(counts[kind]++) + ",";
    }
    return header + "sum\n";
}

void append_row(std::string& text, const Scene& scene, const Ray& point) {
    const Vec3 normal = point.direction.normalized();
    const ShadowedRig lights(*scene.rig, scene.occluders ? &*scene.occluders : nullptr,
                             scene.seen());
    Rgb sum;
    for (std::size_t i = 0; i < scene.rig->sources.size(); ++i) {
        const Rgb lx =
            lights.from_source(i, point.origin, normal, std::nullopt, TubeModel::automatic);
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
    std::vector<Piece> pieces(2 * thread_count(job) + 1);
    const auto write = [&](std::size_t slot) {
        const Piece& piece = pieces[slot];
        count += piece.points;
        if (!piece.rows.empty() && !rows(piece.rows)) return false;
        if (piece.fault) throw *piece.fault;
        return true;
    };
    parallel_stream(pieces.size(), job,
                    {.read = [&](std::size_t slot) { return reader.read(pieces[slot].lines); },
                     .work = [&](std::size_t slot) { work(scene, pieces[slot]); },
                     .write = write});
    return count;
}

} // namespace keiko
