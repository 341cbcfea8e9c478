#include "keiko/radiosity/joined_triangles.h"

#include <algorithm>
#include <map>

namespace keiko {
namespace {

/// True if all normals are within 45 degrees of the mean.
bool is_flat(const ElementMesh& mesh, std::span<const std::uint32_t> triangles) {
    constexpr double least_cosine = 0.70710678118654752;
    Vec3 mean(0);
    for (const std::uint32_t t : triangles) mean += mesh.normal(t);
    mean.normalize();
    return std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t t) {
        return mesh.normal(t).normalized().dot(mean) >= least_cosine;
    });
}

class Joining {
public:
    Joining(const ElementMesh& mesh, const std::function<double(const Box3&)>& allowed,
            double smallest)
        : mesh_(mesh), allowed_(allowed), smallest_(smallest), elements_(mesh.size()) {}

    void add(std::span<const std::uint32_t> triangles) {
        Box3 box;
        for (const std::uint32_t t : triangles)
            for (std::size_t i = 0; i < 3; ++i) box.extend(mesh_.corner(t, i));
        const bool fits = box.size() <= allowed_(box);
        const bool is_element = fits && (box.size() < smallest_ || is_flat(mesh_, triangles));
        if (triangles.size() > 1 && !is_element) {
            const auto [one, other] = halves_of(mesh_, triangles, fits);
            add(one), add(other);
            return;
        }
        for (const std::uint32_t t : triangles) elements_[t] = count_;
        ++count_;
    }
    std::vector<std::uint32_t> taken() { return std::move(elements_); }

private:
    const ElementMesh& mesh_;
    const std::function<double(const Box3&)>& allowed_;
    double smallest_;
    std::vector<std::uint32_t> elements_;
    std::uint32_t count_ = 0;
};

} // namespace

std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>> halves_of(
    const ElementMesh& mesh, std::span<const std::uint32_t> triangles, bool by_normal) {
    const auto place = [&](std::uint32_t t) {
        return by_normal ? mesh.normal(t).normalized() : mesh.middle(t);
    };
    Box3 box;
    for (const std::uint32_t t : triangles) box.extend(place(t));
    const Vec3 extent = box.extent();
    unsigned axis = 0;
    for (const unsigned i : {1U, 2U})
        if (extent[i] > extent[axis]) axis = i;
    std::vector<std::pair<double, std::uint32_t>> order;
    for (const std::uint32_t t : triangles) order.emplace_back(place(t)[axis], t);
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> one, other;
    for (std::size_t i = 0; i < order.size(); ++i)
        (i < order.size() / 2 ? one : other).push_back(order[i].second);
    return {one, other};
}

std::vector<std::uint32_t> joined_triangles(const ElementMesh& mesh,
                                            const std::function<double(const Box3&)>& allowed,
                                            double smallest) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> by_face;
    for (std::uint32_t t = 0; t < mesh.size(); ++t)
        by_face[{mesh.instances[t], mesh.mesh.faces[t]}].push_back(t);
    Joining joining(mesh, allowed, smallest);
    for (const auto& [face, triangles] : by_face) joining.add(triangles);
    return joining.taken();
}

} // namespace keiko
