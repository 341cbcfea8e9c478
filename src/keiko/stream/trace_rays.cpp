#include "keiko/stream/trace_rays.h"

#include "keiko/base/error.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/stream/hit_columns.h"

#include <algorithm>

namespace keiko {

namespace {

struct Piece : RowPiece {
    std::uint64_t rays = 0;
    HitStatistics hits;
};

/// Traces rays and writes their hits.
class RowWriter {
public:
    RowWriter(const Scene& scene, const TraceOptions& options, const Job& job)
        : scene_(scene),
          tracer_(scene.seen()),
          columns_(hit_columns(options.columns)),
          all_(options.all),
          light_(light_column(columns_).has_value()),
          rig_(scene.rig.value_or(LightRig{})),
          picture_(scene.picture(rig_)),
          picture_options_(picture_options(scene)),
          // clang's analyser assumes that a constructor of another file which gets members beside
          // its own by const reference initialises nothing of the object that they all belong to.
          // NOLINTNEXTLINE(clang-analyzer-optin.cplusplus.UninitializedObject)
          integrator_(picture_, picture_options_, std::nullopt, job) {}
    RowWriter(const RowWriter&) = delete;
    RowWriter& operator=(const RowWriter&) = delete;

    std::string header() const { return (all_ ? "ray," : "") + header_of(columns_) + "\n"; }

    /// Fills rows, rays, hits and fault from the lines.
    void work(Piece& piece) const;

private:
    void write_first(Piece& piece, std::span<const Ray> rays) const;
    void write_seen(Piece& piece, std::span<const Ray> rays) const;
    void write_all(Piece& piece, std::span<const Ray> rays) const;
    void write(Piece& piece, const Hit* hit, const Rgb& luminance) const;

    const Scene& scene_;
    const Tracer& tracer_;
    std::vector<HitColumn> columns_;
    bool all_, light_;
    LightRig rig_;
    PictureScene picture_;
    PictureOptions picture_options_;
    Integrator integrator_;
};

void RowWriter::work(Piece& piece) const {
    ParsedRays parsed = rays_of(piece.lines);
    end_before_far_origins(parsed, piece.lines, tracer_.bounds());
    piece.fault = std::move(parsed.fault);
    piece.rays = parsed.rays.size();
    piece.rows.clear();
    piece.hits = {};
    if (all_) return write_all(piece, parsed.rays);
    if (light_) return write_seen(piece, parsed.rays);
    write_first(piece, parsed.rays);
}

void RowWriter::write(Piece& piece, const Hit* hit, const Rgb& luminance) const {
    if (!hit) return append_empty_row(piece.rows, columns_);
    piece.hits.count(*hit);
    Hit told = *hit;
    told.face = scene_.face_id(hit->face);
    append_row(piece.rows, columns_, told, luminance);
}

void RowWriter::write_first(Piece& piece, std::span<const Ray> rays) const {
    for (const std::optional<Hit>& hit : tracer_.nearest(rays))
        write(piece, hit ? &*hit : nullptr, Rgb());
}

void RowWriter::write_seen(Piece& piece, std::span<const Ray> rays) const {
    const SampleBatch view = integrator_.follow(rays);
    for (const PixelSample& sample : view.samples) write(piece, sample.hit, sample.luminance);
}

void RowWriter::write_all(Piece& piece, std::span<const Ray> rays) const {
    std::uint64_t number = piece.lines.first_ray;
    const auto write_numbered = [&](const Hit* hit) {
        append_number(piece.rows, number);
        piece.rows += ',';
        write(piece, hit, Rgb());
    };
    for (const std::vector<Hit>& hits : tracer_.all(rays)) {
        for (const Hit& hit : hits) write_numbered(&hit);
        if (hits.empty()) write_numbered(nullptr);
        ++number;
    }
}

void require_rig(const Scene& scene, const TraceOptions& options) {
    const auto light = light_column(hit_columns(options.columns));
    if (light && !scene.rig)
        throw FieldError("columns", "the column \"" + *light + "\" needs a scene file with a rig");
}

} // namespace

void require_columns(const TraceOptions& options) {
    const auto light = light_column(hit_columns(options.columns));
    if (light && options.all) {
        throw FieldError("columns",
                         "the column \"" + *light + "\" is that of the first hit, not of all");
    }
}

TraceCounts trace_rays(const Scene& scene, const ByteSource& rays, const ByteSink& hits,
                       const TraceOptions& options, const Job& job) {
    require_columns(options);
    require_rig(scene, options);
    const RowWriter writer(scene, options, job);
    TraceCounts counts;
    if (!hits(writer.header())) return counts;
    RayLineReader reader(rays);
    stream_rows<Piece>(
        reader, hits, job, [&](Piece& piece) { writer.work(piece); },
        [&](const Piece& piece) {
            counts.rays += piece.rays;
            counts.hits += piece.hits;
        });
    return counts;
}

} // namespace keiko
