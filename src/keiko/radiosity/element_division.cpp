#include "keiko/radiosity/element_division.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"
#include "keiko/math/quadrature.h"
#include "keiko/radiosity/joined_triangles.h"

#include <algorithm>
#include <string>
#include <utility>

namespace keiko {
namespace {

/// Light of both faces of an element by lamp.
using FaceLights = std::array<std::vector<Rgb>, 2>;

void require_few(std::size_t elements) {
    if (elements > most_elements)
        throw FieldError("element", "needs more than " + std::to_string(most_elements) +
                                        " elements; take a larger one");
}

/// Largest difference of a face of neighbours as a share of the brighter one, or of the mean if
/// that is brighter.
double contrast_of(const BothSides& a, const BothSides& b, double mean) {
    double largest = 0;
    for (std::size_t side = 0; side < 2; ++side) {
        const double brighter = std::max({max_channel(a[side]), max_channel(b[side]), mean});
        if (brighter > 0) largest = std::max(largest, largest_part(a[side] - b[side]) / brighter);
    }
    return largest;
}

class LitDivision {
public:
    LitDivision(ElementSubdivision& triangles, const SurfaceModel& model,
                std::span<const Rgb> levels, double small, const DirectLightOf& light,
                const Job& job)
        : triangles_(triangles),
          model_(model),
          levels_(levels),
          small_(small),
          light_of_(light),
          job_(job) {}

    void light_all() {
        const Elements elements(model_, triangles_.elements());
        lights_.resize(elements.size());
        std::vector<std::uint32_t> all;
        for (std::uint32_t e = 0; e < elements.size(); ++e) all.push_back(e);
        light(elements, all);
    }
    /// Halves elements beside an edge of light once; false if there are none.
    bool halve_at_edges(double contrast, double smallest) {
        std::vector<std::uint32_t> halved = at_edges(contrast, smallest);
        if (halved.empty()) return false;
        cut_single(halved);
        std::vector<std::uint32_t> element_of = triangles_.elements().elements;
        const Elements before(model_, triangles_.elements());
        auto count = static_cast<std::uint32_t>(before.size());
        const std::size_t old = halved.size();
        for (std::size_t i = 0; i < old; ++i) {
            const auto members = before.triangles(halved[i]);
            for (const std::uint32_t t : halves_of(triangles_.elements(), members).second)
                element_of[t] = count;
            halved.push_back(count++);
        }
        triangles_.join(std::move(element_of));
        lights_.resize(count);
        light(Elements(model_, triangles_.elements()), halved);
        return true;
    }
    DirectLights taken() const {
        DirectLights all;
        for (std::size_t lamp = 0; lamp < levels_.size(); ++lamp)
            for (auto& of_lamp = all.by_lamp.emplace_back(); const std::size_t side : {0, 1})
                for (const FaceLights& lights : lights_) of_lamp.push_back(lights[side][lamp]);
        return all;
    }

private:
    void light(const Elements& elements, std::span<const std::uint32_t> which) {
        parallel_for(which.size(), job_, "direct light",
                     [&](std::size_t i) { lights_[which[i]] = lights_of(elements, which[i]); });
    }
    FaceLights lights_of(const Elements& elements, std::uint32_t element) const {
        FaceLights lights{std::vector<Rgb>(levels_.size()), std::vector<Rgb>(levels_.size())};
        for (ElementPoint point : elements.spread(element, small_))
            for (const std::size_t side : {0, 1}) {
                if (side == 1) point.at.normal = -point.at.normal;
                const std::vector<Rgb> lux = light_of_(point.at);
                for (std::size_t lamp = 0; lamp < lux.size(); ++lamp)
                    lights[side][lamp] += lux[lamp] * point.share;
            }
        return lights;
    }
    BothSides sum_of(const FaceLights& lights) const {
        BothSides sum{};
        for (std::size_t lamp = 0; lamp < levels_.size(); ++lamp)
            for (const std::size_t side : {0, 1}) sum[side] += lights[side][lamp] * levels_[lamp];
        return sum;
    }
    /// Mean of the light on the lit faces, lx.
    double mean_light(const Elements& elements, std::span<const BothSides> sums) const {
        double sum = 0, area = 0;
        for (std::size_t e = 0; e < elements.size(); ++e)
            for (const Rgb& lx : sums[e])
                if (const double size = elements.area(e); lx != Rgb())
                    sum += size * max_channel(lx), area += size;
        return area > 0 ? sum / area : 0;
    }
    /// Elements larger than `smallest` that differ from a neighbour, rising. If there is no room
    /// for the halves of all, those are left out that bring the least light by their contrast.
    std::vector<std::uint32_t> at_edges(double contrast, double smallest) const {
        const ElementMesh& mesh = triangles_.elements();
        const Elements elements(model_, mesh);
        std::vector<BothSides> sums;
        for (const FaceLights& lights : lights_) sums.push_back(sum_of(lights));
        const double mean = mean_light(elements, sums);
        std::vector<double> contrasts(elements.size());
        for (const auto& [s, t] : triangles_.neighbours()) {
            const std::uint32_t a = mesh.elements[s], b = mesh.elements[t];
            if (a == b) continue;
            const double found = contrast_of(sums[a], sums[b], mean);
            for (const std::uint32_t e : {a, b}) contrasts[e] = std::max(contrasts[e], found);
        }
        std::vector<std::pair<double, std::uint32_t>> wanted;
        for (std::uint32_t e = 0; e < elements.size(); ++e)
            if (contrasts[e] > contrast && elements.extent(e) > smallest)
                wanted.emplace_back(-contrasts[e] * elements.area(e), e);
        std::sort(wanted.begin(), wanted.end());
        wanted.resize(std::min(wanted.size(), most_elements - elements.size()));
        std::vector<std::uint32_t> chosen;
        for (const auto& [rank, element] : wanted) chosen.push_back(element);
        std::sort(chosen.begin(), chosen.end());
        return chosen;
    }
    /// Cuts the only triangles of elements in two.
    void cut_single(std::span<const std::uint32_t> which) {
        const Elements elements(model_, triangles_.elements());
        std::vector<bool> wanted(triangles_.elements().size());
        for (const std::uint32_t e : which)
            if (elements.triangles(e).size() == 1) wanted[elements.triangles(e)[0]] = true;
        triangles_.cut([&](std::uint32_t t) {
            if (t >= wanted.size() || !wanted[t]) return false;
            wanted[t] = false;
            return true;
        });
    }

    ElementSubdivision& triangles_;
    const SurfaceModel& model_;
    std::span<const Rgb> levels_;
    double small_; ///< mm, extent of elements with one point
    const DirectLightOf& light_of_;
    const Job& job_;
    std::vector<FaceLights> lights_; ///< an element
};

/// Distance of a box from the nearest place of another.
double distance(const Box3& box, const Box3& other) {
    Vec3 way(0);
    for (unsigned i = 0; i < 3; ++i)
        way[i] = std::max({box.lower[i] - other.upper[i], 0.0, other.lower[i] - box.upper[i]});
    return way.length();
}

} // namespace

DirectLights divide_and_light(ElementSubdivision& triangles, const SurfaceModel& model,
                              const RadiositySpec& spec, const Box3& near,
                              std::span<const Rgb> levels, const DirectLightOf& light,
                              const Job& job) {
    const ElementMesh& mesh = triangles.elements();
    const auto allowed = [&](const Box3& box) {
        return std::max(spec.element, distance(near, box) / 2);
    };
    triangles.cut([&](std::uint32_t t) {
        Box3 box;
        for (std::size_t i = 0; i < 3; ++i) box.extend(mesh.corner(t, i));
        return mesh.longest_side(t) > allowed(box);
    });
    triangles.join(joined_triangles(mesh, allowed, spec.smallest));
    require_few(Elements(model, mesh).size());
    LitDivision lit(triangles, model, levels, spec.smallest, light, job);
    lit.light_all();
    while (lit.halve_at_edges(spec.contrast, spec.smallest)) job.check();
    return lit.taken();
}

} // namespace keiko
