#include "keiko/radiosity/solve_elements.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/radiosity/bounced_light.h"
#include "keiko/radiosity/element_rows.h"
#include "keiko/radiosity/interpolated_radiosity.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace keiko {
namespace {

/// The light of all lamps at their levels.
Rgb at_levels(std::span<const BouncedLight> lamps, std::span<const Rgb> levels,
              std::vector<Rgb> BouncedLight::*what, std::size_t face) {
    Rgb sum;
    for (std::size_t lamp = 0; lamp < lamps.size(); ++lamp)
        sum += (lamps[lamp].*what)[face] * levels[lamp];
    return sum;
}

class Solving {
public:
    Solving(const ReflectingScene& scene, const ElementMesh& mesh, const DirectLights& direct,
            std::span<const Rgb> levels, const RadiositySpec& spec)
        : scene_(scene),
          direct_(direct),
          levels_(levels),
          spec_(spec),
          elements_(scene.model, mesh),
          triangles_(solved_triangles(mesh)),
          locator_(scene.model, mesh.uv, triangles_),
          rays_(scene.tracer, locator_, triangles_, elements_.size()),
          rows_(elements_, rays_, spec.rays) {
        for (std::size_t face = 0; face < rows_.size(); ++face) {
            const std::size_t e = face % elements_.size();
            areas_.push_back(elements_.area(e));
            reflectances_.push_back(
                scene.reflectances[mesh.mesh.faces[elements_.triangles(e).front()]]);
        }
    }

    RadiositySolution solved(const Job& job) {
        try {
            rows_.compute(lit_faces(), job);
        } catch (const Cancelled&) { // rows by fewer rays remain
        }
        Job unstopped = job; // takes a moment, and makes a solution of what there is
        unstopped.stop = {};
        std::optional<StopScope::Shared> no_scope(nullptr);
        for (const auto& direct : direct_.by_lamp)
            bounced_.push_back(bounced_light(rows_, areas_, reflectances_, exitance(direct),
                                             spec_.error, unstopped));
        no_scope.reset();
        RadiositySolution solution = of_elements();
        try {
            gather_at_corners(solution, job);
        } catch (const Cancelled&) { // corners have the light of the elements around
        }
        return solution;
    }

private:
    std::vector<bool> lit_faces() const {
        std::vector<bool> lit(rows_.size());
        for (const auto& lamp : direct_.by_lamp)
            for (std::size_t face = 0; face < lamp.size(); ++face)
                if (lamp[face] != Rgb()) lit[face] = true;
        return lit;
    }
    std::vector<Rgb> exitance(std::span<const Rgb> direct) const {
        std::vector<Rgb> all;
        for (std::size_t face = 0; face < direct.size(); ++face)
            all.push_back(reflectances_[face] * direct[face]);
        return all;
    }
    EnergyBalance balance() const {
        std::vector<Reflector> reflectors;
        std::vector<Rgb> arriving;
        Rgb escaped;
        for (std::size_t face = 0; face < rows_.size(); ++face) {
            Rgb direct;
            for (std::size_t lamp = 0; lamp < levels_.size(); ++lamp)
                direct += direct_.by_lamp[lamp][face] * levels_[lamp];
            reflectors.push_back({reflectances_[face], reflectances_[face] * direct});
            arriving.push_back(at_levels(bounced_, levels_, &BouncedLight::arriving, face));
            escaped += at_levels(bounced_, levels_, &BouncedLight::radiosity, face) *
                       (areas_[face] * rows_.leaving(face));
        }
        return energy_balance(areas_, reflectors, arriving, escaped);
    }
    /// The solution with corners that have the mean light of the elements around.
    RadiositySolution of_elements() const {
        RadiositySolution solution{};
        solution.corners = elements_.mesh().uv;
        solution.triangles = triangles_;
        solution.elements = elements_.size();
        solution.factor_rows = rows_.computed();
        solution.element_size = spec_.element;
        solution.balance = balance();
        for (const BouncedLight& lamp : bounced_) {
            solution.remaining = std::max(solution.remaining, lamp.remaining);
            solution.lamps.push_back({means_at_corners(lamp), by_element(lamp.exitance)});
        }
        return solution;
    }
    std::vector<BothSides> by_element(std::span<const Rgb> faces) const {
        std::vector<BothSides> both;
        for (std::size_t e = 0; e < elements_.size(); ++e)
            both.push_back({faces[e], faces[elements_.size() + e]});
        return both;
    }
    std::vector<BothSides> means_at_corners(const BouncedLight& lamp) const {
        const ElementMesh& mesh = elements_.mesh();
        std::vector<BothSides> light(mesh.uv.size());
        std::vector<double> areas(light.size());
        const std::vector<BothSides> of_elements = by_element(lamp.arriving);
        for (std::size_t t = 0; t < mesh.size(); ++t)
            for (const std::uint32_t corner : mesh.mesh.triangles[t]) {
                areas[corner] += mesh.area(t);
                for (const std::size_t side : {0, 1})
                    light[corner][side] += of_elements[mesh.elements[t]][side] * mesh.area(t);
            }
        for (std::size_t c = 0; c < light.size(); ++c)
            for (Rgb& value : light[c]) value = areas[c] > 0 ? value / areas[c] : Rgb();
        return light;
    }
    /// A triangle at each corner, the first, and the shares of its corners there.
    std::vector<std::optional<std::pair<std::uint32_t, Vec3>>> corner_places() const {
        constexpr double inward = 0.02; // off the border, where rays could pass beside walls
        const ElementMesh& mesh = elements_.mesh();
        std::vector<std::optional<std::pair<std::uint32_t, Vec3>>> places(mesh.uv.size());
        for (std::uint32_t t = 0; t < mesh.size(); ++t)
            for (unsigned i = 0; i < 3; ++i) {
                Vec3 shares(inward);
                shares[i] = 1 - 2 * inward;
                auto& place = places[mesh.mesh.triangles[t][i]];
                if (!place) place = {t, shares};
            }
        return places;
    }
    /// Replaces the means at corners by what is gathered there.
    void gather_at_corners(RadiositySolution& solution, const Job& job) const {
        const auto places = corner_places();
        const std::vector<LampSolution> means = solution.lamps;
        std::vector<InterpolatedRadiosity> radiosities;
        for (std::size_t lamp = 0; lamp < means.size(); ++lamp)
            radiosities.emplace_back(triangles_, means[lamp].arriving, bounced_[lamp].exitance,
                                     reflectances_);
        constexpr std::size_t at_once = 16;
        parallel_for((places.size() + at_once - 1) / at_once, job, "gathering",
                     [&](std::size_t piece) {
                         const std::size_t end = std::min(places.size(), (piece + 1) * at_once);
                         for (std::size_t c = piece * at_once; c < end; ++c)
                             if (places[c]) gather_at(c, *places[c], radiosities, solution);
                     });
    }
    void gather_at(std::size_t corner, const std::pair<std::uint32_t, Vec3>& place,
                   std::span<const InterpolatedRadiosity> radiosities,
                   RadiositySolution& solution) const {
        LightPoint point = elements_.point_of_triangle(place.first, place.second);
        const std::size_t element = triangles_[place.first].element, count = elements_.size();
        for (const std::size_t side : {0, 1}) {
            if (side == 1) point.normal = -point.normal;
            if (!rows_.reached()[element + side * count]) continue;
            const auto met = rays_.met({&point, 1}, spec_.rays, 4 * count + 2 * corner + side);
            for (std::size_t lamp = 0; lamp < radiosities.size(); ++lamp)
                solution.lamps[lamp].arriving[corner][side] = radiosities[lamp].mean(met);
        }
    }

    const ReflectingScene& scene_;
    const DirectLights& direct_;
    std::span<const Rgb> levels_;
    const RadiositySpec& spec_;
    Elements elements_;
    std::vector<SolvedTriangle> triangles_;
    ElementLocator locator_;
    GatherRays rays_;
    ElementRows rows_;
    std::vector<double> areas_;         ///< a face
    std::vector<Rgb> reflectances_;     ///< a face
    std::vector<BouncedLight> bounced_; ///< a lamp
};

} // namespace

std::vector<SolvedTriangle> solved_triangles(const ElementMesh& mesh) {
    std::vector<SolvedTriangle> triangles;
    for (std::size_t t = 0; t < mesh.size(); ++t)
        triangles.push_back(
            {mesh.mesh.triangles[t], mesh.elements[t], mesh.instances[t], mesh.mesh.faces[t]});
    return triangles;
}

RadiositySolution solve_elements(const ReflectingScene& scene, const ElementMesh& mesh,
                                 const DirectLights& direct, std::span<const Rgb> levels,
                                 const RadiositySpec& spec, const Job& job) {
    return Solving(scene, mesh, direct, levels, spec).solved(job);
}

} // namespace keiko
