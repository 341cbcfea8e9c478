#include "keiko/inspect/lines/surface_lines.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/inspect/basics/face_box.h"
#include "keiko/inspect/basics/visible_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace keiko {
namespace {

/// Visibility of one level's line from the viewpoint of a field.
class LineVisibility {
public:
    /// `seen`: all possible occluders; `level`: into those of the lamps. Keeps references.
    LineVisibility(const Tracer& seen, const LampLevels& lamps, std::size_t level);

    /// True if the place is visible from the viewpoint and the lamp of the line is visible in it.
    /// The ray to the viewpoint must be free and, for reflections, the mirrored one up to the
    /// C-plane too. Reflection and highlight lines end with the lamp. An occluder less than 0.2 mm
    /// from the place (2e-4 of the size of the visible geometry) is the other side of a seam and
    /// hides no line. Isophotes are kept where the normal towards the viewpoint faces the lamps.
    /// `normal` is unit, `root` the place's own.
    bool sees(const Vec3& place, const Vec3& normal, const Root& root) const;

private:
    bool on_lamp(const LineField::Image& image, const Vec3& place) const;
    Ray to_eye(const Vec3& place) const;

    const Tracer& seen_;
    const LineSource& source_;
    const LineField& field_;
    double level_;
    double begin_; ///< mm
};

/// mm, and share of the size of the visible geometry: an occluder nearer than this is the other
/// side of a seam, which is a little higher. A line does not end there.
constexpr double nearest_occluder = 0.2, nearest_in_sizes = 2e-4;

LineVisibility::LineVisibility(const Tracer& seen, const LampLevels& lamps, std::size_t level)
    : seen_(seen),
      source_(lamps.source),
      field_(lamps.field),
      level_(lamps.levels[level]),
      begin_(std::min(nearest_occluder, nearest_in_sizes * seen.bounds().size())) {}

bool LineVisibility::on_lamp(const LineField::Image& image, const Vec3& place) const {
    // At a collapsed edge the field is 0 on every level, and does not identify the lamp.
    constexpr double rounding = 1e-4; // degrees
    const bool isophote = field_.look() == LineLook::isophote;
    // An isophote has levels of both signs, as the patch's own normal may point away from the
    // viewpoint.
    const double level = isophote ? std::abs(level_) : level_;
    if (!image.faces || !(field_.normal_turn(image, level - image.value) < rounding)) return false;
    return isophote || (image.along >= 0 && image.along <= field_.plane().length &&
                        source_.is_visible_from(place));
}

Ray LineVisibility::to_eye(const Vec3& place) const {
    Ray ray;
    ray.origin = place;
    ray.direction = -field_.eye().towards(place);
    if (!field_.eye().parallel) ray.t_max = 1;
    ray.t_min = begin_ / ray.direction.length();
    return ray;
}

bool LineVisibility::sees(const Vec3& place, const Vec3& normal, const Root& root) const {
    const LineField::Image image = field_.image(place, normal);
    if (!on_lamp(image, place)) return false;
    Ray ray = to_eye(place);
    ray.excluded = root;
    if (seen_.any(ray)) return false;
    if (field_.look() != LineLook::reflection) return true;
    const Vec3 towards = -ray.direction.normalized();
    Ray mirrored;
    mirrored.origin = place;
    mirrored.direction = reflect(towards, normal);
    mirrored.t_min = begin_;
    mirrored.t_max = image.reach;
    mirrored.excluded = root;
    return !seen_.any(mirrored);
}

/// Share of the patch: larger than the distance by which rounding parts a root of the line from the
/// tracer's.
constexpr double own_root = 1e-7;
/// Least chord error as a share of the body's size: finer chords of a body as large as a planet
/// never terminate.
constexpr double least_chord_error = 1e-10;

struct PatchInstance {
    std::uint32_t instance = 0, face = 0, patch = 0;
};

std::vector<PatchInstance> patch_instances(const SurfaceModel& model) {
    std::vector<PatchInstance> placed;
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = 0; f < part.face_count; ++f) {
            const Face& face = model.faces[part.first_face + f];
            for (std::uint32_t p = 0; p < face.patch_count; ++p)
                placed.push_back({i, part.first_face + f, face.first_patch + p});
        }
    }
    return placed;
}

class LineFinder {
public:
    LineFinder(const SurfaceModel& model, const Tracer& seen, std::span<const LineSource> sources,
               const Camera& camera, const SurfaceLineOptions& options, const Job& job)
        : model_(model), seen_(seen), lines_(options.lines) {
        const Box3 body = material_bounds(model, job);
        step_ = options.test_step * body.size();
        lines_.chord_error = std::max(lines_.chord_error, least_chord_error * body.size());
        for (const LineSource& source : sources)
            fields_.push_back(lamp_levels(options.look, LineEye(camera), source, body.center()));
        for (const Face& face : model.faces) trims_.emplace_back(model, face);
    }

    std::vector<SurfaceLine> on(const PatchInstance& placed) const {
        const BezierPatchView own = model_.patch(placed.patch);
        std::vector<Vec4> points;
        for (const Vec4& p : own.points)
            points.push_back(model_.instances[placed.instance].transform.homogeneous(p));
        const BezierPatchView patch{own.degree_u, own.degree_v, points};
        std::vector<SurfaceLine> found;
        for (std::uint32_t plane = 0; plane < fields_.size(); ++plane)
            add(placed, patch, plane, found);
        return found;
    }

private:
    void add(const PatchInstance& placed, const BezierPatchView& patch, std::uint32_t plane,
             std::vector<SurfaceLine>& found) const {
        const LampLevels& lamps = fields_[plane];
        PatchLineOptions options = lines_;
        options.cells.unwanted = [&](const Box2& uv) {
            return side_of(placed, uv) == TrimSide::outside;
        };
        const auto bordered = [&](const Box2& uv) {
            return side_of(placed, uv) == TrimSide::mixed;
        };
        for (const PatchLine& line : patch_lines(patch, lamps.field, lamps.levels, options)) {
            const LevelFunction f(patch, lamps.field, lamps.levels[line.level]);
            const LineVisibility sight(seen_, lamps, line.level);
            const auto visible = [&](const LinePoint& p) {
                return sees(sight, placed, patch, p.uv);
            };
            for (PatchLine& piece : visible_pieces(line, f, step_, visible, bordered))
                found.push_back({plane, line.level % lamps.lamps, placed.instance, placed.face,
                                 placed.patch, std::move(piece)});
        }
    }

    /// Position of a box of a patch relative to the trims of its face.
    TrimSide side_of(const PatchInstance& placed, const Box2& uv) const {
        const TrimRegion& trim = trims_[placed.face];
        if (trim.untrimmed()) return TrimSide::inside;
        return trim.classify(face_box(model_, placed.patch, uv));
    }

    bool sees(const LineVisibility& sight, const PatchInstance& placed,
              const BezierPatchView& patch, const Vec2& uv) const {
        const TrimRegion& trim = trims_[placed.face];
        if (!trim.untrimmed() && !trim.contains(model_.face_parameters(placed.patch, uv)))
            return false;
        const SurfaceDerivatives s = evaluate(patch, uv, 2);
        const std::optional<Vec3> normal = robust_normal(s, uv);
        const Root root{placed.instance, placed.patch, Box2{uv, uv}.padded(own_root)};
        return normal && sight.sees(s.position(), *normal, root);
    }

    const SurfaceModel& model_;
    const Tracer& seen_;
    PatchLineOptions lines_;
    double step_ = 0; ///< mm
    std::vector<LampLevels> fields_;
    std::vector<TrimRegion> trims_; ///< by face
};

} // namespace

double LampLevels::step(std::uint32_t lamp) const {
    if (lamps < 2) return 0;
    const std::uint32_t from = lamp + 1 < lamps ? lamp : lamp - 1;
    return std::abs(levels[from + 1] - levels[from]);
}

LampLevels lamp_levels(LineLook look, const LineEye& eye, const LineSource& source,
                       const Vec3& body) {
    LampLevels lamps{source, LineField(look, eye, source.row, body), {}, 0};
    const CPlaneFrame& frame = lamps.field.plane();
    lamps.lamps = static_cast<std::uint32_t>(frame.lamps);
    for (int i = 0; i < frame.lamps; ++i)
        lamps.levels.push_back(look == LineLook::isophote
                                   ? std::cos(std::numbers::pi / 2 * (i + 0.5) / frame.lamps)
                                   : frame.axis(i));
    if (look == LineLook::isophote)
        for (std::uint32_t i = 0; i < lamps.lamps; ++i) lamps.levels.push_back(-lamps.levels[i]);
    return lamps;
}

std::vector<SurfaceLine> surface_lines(const SurfaceModel& model, const Tracer& seen,
                                       std::span<const LineSource> sources, const Camera& camera,
                                       const SurfaceLineOptions& options, const Job& job) {
    const std::vector<PatchInstance> placed = patch_instances(model);
    const LineFinder finder(model, seen, sources, camera, options, job);
    std::vector<std::vector<SurfaceLine>> found(placed.size());
    parallel_for(placed.size(), job, "lines",
                 [&](std::size_t i) { found[i] = finder.on(placed[i]); });
    std::vector<SurfaceLine> lines;
    for (std::vector<SurfaceLine>& some : found)
        std::move(some.begin(), some.end(), std::back_inserter(lines));
    std::stable_sort(lines.begin(), lines.end(), [](const SurfaceLine& a, const SurfaceLine& b) {
        return std::tie(a.plane, a.lamp) < std::tie(b.plane, b.lamp);
    });
    return lines;
}

double length_of(const PatchLine& line) {
    double length = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
        length += (line.points[i].place - line.points[i - 1].place).length();
    return length;
}

} // namespace keiko
