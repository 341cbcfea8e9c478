#include "keiko/workflow/luminous_faces.h"

#include "keiko/base/error.h"
#include "keiko/compare/alignment/placed_model.h"
#include "keiko/geometry/seam/closed_borders.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/import/worker/mesh_in_worker.h"
#include "keiko/maps/scene_maps.h"
#include "keiko/math/bounds.h"
#include "keiko/math/disjoint_sets.h"
#include "keiko/render/shading/traced_lamp.h"
#include "keiko/workflow/flat_lamps.h"
#include "keiko/workflow/luminous_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace keiko {
namespace {

/// Placed faces that shine with one luminance: all of their instances.
struct LampFaces {
    std::vector<std::uint32_t> instances; ///< rising
    std::vector<std::uint32_t> faces;     ///< rising
    bool is_uniform = true;               ///< no map varies the luminance
};

/// The luminous faces of a model, instance by instance, by luminance and by what varies it.
std::vector<LampFaces> lamp_faces(const SurfaceModel& model, std::span<const Material> materials) {
    std::vector<LampFaces> lamps;
    for (std::uint32_t i = 0; i < model.instances.size(); ++i) {
        const std::size_t first = lamps.size();
        const Part& part = model.parts[model.instances[i].part];
        for (std::uint32_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
            const Material& own = materials[f];
            if (own.emits == Rgb(0)) continue;
            const bool is_uniform = !has_emission_map(own);
            const auto found = std::find_if(
                lamps.begin() + static_cast<std::ptrdiff_t>(first), lamps.end(),
                [&](const LampFaces& lamp) {
                    const Material& first_face = materials[lamp.faces.front()];
                    return is_uniform && lamp.is_uniform && first_face.emits == own.emits &&
                           first_face.emits_both_ways == own.emits_both_ways;
                });
            if (found == lamps.end())
                lamps.push_back({{i}, {f}, is_uniform});
            else
                found->faces.push_back(f);
        }
    }
    return lamps;
}

/// The faces of a lamp, placed.
PlacedModel placed_lamp(const SurfaceModel& body, const LampFaces& lamp) {
    SurfaceModel model = body;
    model.instances.clear();
    for (const std::uint32_t i : lamp.instances) model.instances.push_back(body.instances[i]);
    return placed_model(model, {}, lamp.faces);
}

/// One lamp of several with the same luminance.
LampFaces joined(std::span<const LampFaces> lamps) {
    LampFaces all;
    for (const LampFaces& lamp : lamps) {
        all.instances.insert(all.instances.end(), lamp.instances.begin(), lamp.instances.end());
        all.faces.insert(all.faces.end(), lamp.faces.begin(), lamp.faces.end());
    }
    std::sort(all.faces.begin(), all.faces.end());
    all.faces.erase(std::unique(all.faces.begin(), all.faces.end()), all.faces.end());
    return all;
}

/// Lamps of one luminance, each of an instance of its own, by what touches.
std::vector<std::vector<LampFaces>> touching(const SurfaceModel& body,
                                             const std::vector<LampFaces>& lamps, const Job& job) {
    const PlacedModel placed = placed_lamp(body, joined(lamps));
    const auto sets = connected_faces(placed.model, closing_join(placed.model), job);
    DisjointSets of_lamps(lamps.size());
    for (std::size_t f = 0; f < sets.size(); ++f)
        of_lamps.join(placed.origin[f].instance, placed.origin[sets[f]].instance);
    std::map<std::size_t, std::vector<LampFaces>> groups;
    for (std::size_t i = 0; i < lamps.size(); ++i) groups[of_lamps.root(i)].push_back(lamps[i]);
    std::vector<std::vector<LampFaces>> all;
    for (auto& [first, group] : groups) all.push_back(std::move(group));
    return all;
}

/// mm, the second longest side of a model's box.
double second_extent(const SurfaceModel& model, const Job& job) {
    const Vec3 extent = material_bounds(model, job).extent();
    std::array<double, 3> sides{extent.x, extent.y, extent.z};
    std::sort(sides.begin(), sides.end());
    return sides[1];
}

/// Makes the lights of one body.
class BodyLamps {
public:
    BodyLamps(const SurfaceModel& body, std::span<const Material> materials,
              const LoadOptions& options, double deviation, const Job& job)
        : body_(body), materials_(materials), options_(options), deviation_(deviation), job_(job) {}

    std::vector<LightSource> of(const std::vector<LampFaces>& lamps) const {
        std::vector<LightSource> lights;
        std::map<std::pair<std::array<double, 3>, bool>, std::vector<LampFaces>> open; // by light
        for (const LampFaces& lamp : lamps) {
            const Material& own = material_of(lamp);
            if (!lamp.is_uniform)
                append(in_panels(lamp), lights);
            else if (auto light = as_body(lamp))
                append(std::move(*light), lights);
            else
                open[{{own.emits.r, own.emits.g, own.emits.b}, own.emits_both_ways}].push_back(
                    lamp);
        }
        for (const auto& [light_of_parts, parts] : open)
            for (const std::vector<LampFaces>& group : touching(body_, parts, job_)) {
                // Files may place each face of a body by itself.
                auto light = group.size() > 1 ? as_body(joined(group)) : std::nullopt;
                if (!light) light = as_sheets(joined(group));
                if (light)
                    append(std::move(*light), lights);
                else
                    for (const LampFaces& part : group) append(in_panels(part), lights);
            }
        return lights;
    }

private:
    const Material& material_of(const LampFaces& lamp) const {
        return materials_[lamp.faces.front()];
    }
    template <class Light>
    static void append(std::vector<Light> more, std::vector<LightSource>& lights) {
        for (Light& light : more) lights.emplace_back(std::move(light));
    }
    /// Panels of flat faces that hide nothing of each other, which are exact; nullopt for others.
    std::optional<std::vector<LightSource>> as_flat_faces(const PlacedModel& placed,
                                                          const LampFaces& lamp) const {
        if (!is_flat(placed.model)) return std::nullopt;
        std::vector<PolygonLight> panels = in_panels(placed, lamp);
        if (!hide_nothing(panels)) return std::nullopt;
        std::vector<LightSource> lights;
        append(std::move(panels), lights);
        return lights;
    }
    /// The light of a closed body, or of a convex one in panels; nullopt for any other.
    std::optional<std::vector<LightSource>> as_body(const LampFaces& lamp) const {
        const PlacedModel placed = placed_lamp(body_, lamp);
        if (!borders_close(placed.model, closing_join(placed.model), job_)) return std::nullopt;
        if (auto panels = as_flat_faces(placed, lamp)) return panels;
        auto light = by_contour(placed.model, lamp);
        if (!light) return std::nullopt;
        return std::vector<LightSource>{std::move(*light)};
    }
    /// The light of open faces, by their contour unless panels are exact; nullopt for those whose
    /// outlines are not known.
    std::optional<std::vector<LightSource>> as_sheets(const LampFaces& lamp) const {
        const PlacedModel placed = placed_lamp(body_, lamp);
        if (auto panels = as_flat_faces(placed, lamp)) return panels;
        const Material& own = material_of(lamp);
        const LampSides sides = own.emits_both_ways ? LampSides::both_sides : LampSides::outer_side;
        auto body = std::make_shared<const TracedLamp>(placed.model, job_, sides);
        if (!body->has_known_outlines()) return std::nullopt;
        return std::vector<LightSource>{ContourLight{std::move(body), own.emits}};
    }
    /// nullopt for faces that are no closed body.
    std::optional<ContourLight> by_contour(const SurfaceModel& placed,
                                           const LampFaces& lamp) const {
        auto body = std::make_shared<const TracedLamp>(placed, job_);
        if (!body->is_closed(job_)) return std::nullopt;
        return ContourLight{std::move(body), material_of(lamp).emits};
    }
    std::vector<PolygonLight> in_panels(const LampFaces& lamp) const {
        return in_panels(placed_lamp(body_, lamp), lamp);
    }
    std::vector<PolygonLight> in_panels(const PlacedModel& placed, const LampFaces& lamp) const {
        const SurfaceModel& model = placed.model;
        // A flat face is one panel, however many corners it has.
        constexpr double finer = 1.0 / 32;
        const double off = deviation_ * second_extent(model, job_) * (is_flat(model) ? finer : 1);
        const ModelMesh mesh = mesh_in_worker(model, off, options_, job_);
        const FaceParameters parameters(model);
        std::vector<PolygonLight> all;
        for (std::size_t f = 0; f < mesh.size(); ++f) {
            if (!mesh[f].problem.empty())
                throw Error(body_.source, body_.describe(model.faces[f]),
                            "its light is unknown: " + mesh[f].problem);
            for (PolygonLight& panel :
                 luminous_panels(model, model.faces[f], mesh[f], material_of(lamp), parameters))
                all.push_back(std::move(panel));
        }
        return all;
    }

    const SurfaceModel& body_;
    std::span<const Material> materials_;
    const LoadOptions& options_;
    double deviation_;
    const Job& job_;
};

} // namespace

std::vector<LightSource> luminous_faces(const SurfaceModel& body,
                                        std::span<const Material> materials,
                                        const LoadOptions& options, const Job& job,
                                        double deviation) {
    return BodyLamps(body, materials, options, deviation, job).of(lamp_faces(body, materials));
}

} // namespace keiko
