#include "keiko/radiosity/solve_elements.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/math/quadrature.h"
#include "keiko/radiosity/element_rows.h"
#include "keiko/radiosity/progressive_refinement.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace keiko {
namespace {

/// Distance of a point from a box; 0 inside.
double distance(const Box3& box, const Vec3& point) {
    Vec3 way(0);
    for (unsigned i = 0; i < 3; ++i)
        way[i] = std::max({box.lower[i] - point[i], 0.0, point[i] - box.upper[i]});
    return way.length();
}

/// Distance of a box from the nearest place of an element, at least.
double least_distance(const Box3& box, const ElementMesh& elements, std::uint32_t triangle) {
    return std::max(0.0,
                    distance(box, elements.middle(triangle)) - elements.longest_side(triangle));
}

/// True if a side of neighbours differs by more than the contrast of the brighter one, or of the
/// mean if that is brighter.
bool differ(const std::array<Rgb, 2>& a, const std::array<Rgb, 2>& b, double contrast,
            double mean) {
    for (std::size_t side = 0; side < 2; ++side) {
        const double brighter = std::max({max_channel(a[side]), max_channel(b[side]), mean});
        if (largest_part(a[side] - b[side]) > contrast * brighter) return true;
    }
    return false;
}

class LitElements {
public:
    LitElements(ElementSubdivision& elements, const DirectLightOf& light, const Job& job)
        : elements_(elements), light_of_(light), job_(job) {}

    void light(std::span<const std::uint32_t> triangles) {
        light_.resize(elements_.elements().size());
        parallel_for(triangles.size(), job_, "direct light", [&](std::size_t i) {
            light_[triangles[i]] = light_of_(elements_.elements(), triangles[i]);
        });
    }
    void light_all() {
        std::vector<std::uint32_t> all(elements_.elements().size());
        std::iota(all.begin(), all.end(), 0);
        light(all);
    }
    /// Cuts elements beside an edge of light once; false if there are none.
    bool cut_at_edges(double contrast, double smallest) {
        std::vector<bool> at_edge(light_.size());
        const double mean = mean_light();
        for (const auto& [a, b] : elements_.neighbours())
            if (differ(light_[a], light_[b], contrast, mean)) at_edge[a] = at_edge[b] = true;
        const auto changed = elements_.cut([&](std::uint32_t t) {
            if (t >= at_edge.size() || !at_edge[t]) return false;
            at_edge[t] = false;
            return elements_.elements().longest_side(t) > smallest;
        });
        light(changed);
        return !changed.empty();
    }
    std::vector<std::array<Rgb, 2>> taken() { return std::move(light_); }

private:
    /// Mean of the light on the lit faces, lx.
    double mean_light() const {
        double sum = 0, area = 0;
        for (std::size_t t = 0; t < light_.size(); ++t)
            for (const Rgb& lx : light_[t])
                if (const double size = elements_.elements().area(t); lx != Rgb())
                    sum += size * max_channel(lx), area += size;
        return area > 0 ? sum / area : 0;
    }

    ElementSubdivision& elements_;
    const DirectLightOf& light_of_;
    const Job& job_;
    std::vector<std::array<Rgb, 2>> light_;
};

/// Fronts, then backs, of elements as reflectors.
std::vector<Reflector> reflectors_of(const ElementMesh& elements,
                                     std::span<const std::array<Rgb, 2>> direct,
                                     std::span<const Rgb> reflectances) {
    std::vector<Reflector> all;
    for (const std::size_t side : {0, 1})
        for (std::size_t t = 0; t < elements.size(); ++t) {
            const Rgb& rho = reflectances[elements.mesh.faces[t]];
            all.push_back({rho, rho * direct[t][side]});
        }
    return all;
}

/// Faces of elements that shine, those with most light first.
std::vector<std::size_t> brightest_first(const ElementMesh& elements,
                                         std::span<const Reflector> reflectors) {
    std::vector<double> flux;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < reflectors.size(); ++i) {
        flux.push_back(luminance(reflectors[i].exitance) * elements.area(i % elements.size()));
        if (flux[i] > 0) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return flux[a] > flux[b]; });
    return order;
}

/// Faces that have light, their own or what has arrived.
std::vector<std::size_t> shining_faces(std::span<const Rgb> radiosity,
                                       std::span<const Rgb> arriving) {
    std::vector<std::size_t> faces;
    for (std::size_t i = 0; i < arriving.size(); ++i)
        if (radiosity[i] != Rgb() || arriving[i] != Rgb()) faces.push_back(i);
    return faces;
}

/// Solution of elements by the light that arrives at their faces, fronts first.
RadiositySolution solution_of(const ElementMesh& elements, std::span<const Reflector> reflectors,
                              std::span<const Rgb> arriving) {
    RadiositySolution solution{};
    solution.corners = elements.mesh.positions;
    solution.triangles = elements.mesh.triangles;
    const std::size_t count = elements.size();
    const auto light = [&](std::size_t face) {
        return ElementLight{arriving[face], reflectors[face].exitance +
                                                reflectors[face].reflectance * arriving[face]};
    };
    for (std::size_t t = 0; t < count; ++t) solution.light.push_back({light(t), light(count + t)});
    return solution;
}

} // namespace

std::vector<std::array<Rgb, 2>> light_elements(ElementSubdivision& elements,
                                               const RadiositySpec& spec, const Box3& near,
                                               const DirectLightOf& light, const Job& job) {
    const ElementMesh& mesh = elements.elements();
    elements.cut([&](std::uint32_t t) {
        return mesh.longest_side(t) > std::max(spec.element, least_distance(near, mesh, t) / 2);
    });
    LitElements lit(elements, light, job);
    lit.light_all();
    while (lit.cut_at_edges(spec.contrast, spec.smallest)) job.check();
    return lit.taken();
}

RadiositySolution solve_elements(const ElementMesh& elements,
                                 std::span<const std::array<Rgb, 2>> direct,
                                 std::span<const Rgb> reflectances, const RadiositySpec& spec,
                                 const Job& job) {
    const std::vector<Reflector> reflectors = reflectors_of(elements, direct, reflectances);
    ElementRows rows(elements, spec.cells, brightest_first(elements, reflectors), job);
    std::vector<double> areas;
    for (std::size_t i = 0; i < reflectors.size(); ++i) areas.push_back(rows.area(i));
    ProgressiveRefinement light(areas, reflectors, [&](std::size_t i) { return rows.row(i); });
    std::vector<Rgb> arriving;
    Rgb escaped;
    try {
        light.refine(spec.error, std::numeric_limits<int>::max(), job);
        const std::vector<Rgb> radiosity = light.radiosity();
        const auto faces = shining_faces(radiosity, light.arriving());
        arriving = rows.gathered(radiosity, faces);
        escaped = rows.escaped(radiosity, faces);
    } catch (const Cancelled&) {
        arriving = light.arriving(), escaped = light.escaped();
    }
    RadiositySolution solution = solution_of(elements, reflectors, arriving);
    solution.remaining = light.remaining();
    solution.balance = energy_balance(areas, reflectors, arriving, escaped);
    return solution;
}

} // namespace keiko
