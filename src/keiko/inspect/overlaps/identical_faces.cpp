#include "keiko/inspect/overlaps/identical_faces.h"

#include "keiko/base/parallel.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/inspect/basics/material_places.h"
#include "keiko/inspect/overlaps/place_on_face.h"
#include "keiko/inspect/structure/edge_runs.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace keiko {
namespace {

/// The faces of a model with their boxes and borders. Keeps a reference to the borders.
class FaceTable {
public:
    explicit FaceTable(const ModelBorders& borders);

    const SurfaceModel& model() const { return borders_.model; }
    std::size_t count() const { return faces_.size(); }
    const PlacedFace& face(std::size_t i) const { return faces_[i]; }
    /// Places of its border curves; world, mm.
    std::vector<Vec3> places_of_borders(std::size_t i) const {
        return border_places(borders_.curves, curves_[i]);
    }
    /// Places of its material in a grid on each of its patches; world, mm.
    std::vector<Vec3> inner_places(std::size_t i) const;
    /// The faces but itself whose boxes hold its borders to within `reach` mm.
    std::vector<std::size_t> around(std::size_t i, double reach) const;

private:
    const ModelBorders& borders_;
    std::vector<PlacedFace> faces_;
    std::vector<Box3> hulls_, outlines_; ///< of the control points, and of places of the borders
    std::vector<std::vector<BoundaryInterval>> curves_;
    BoxTree tree_{{}};
};

FaceTable::FaceTable(const ModelBorders& borders)
    : borders_(borders), faces_(placed_faces(borders.model)) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> numbers;
    for (std::size_t i = 0; i < count(); ++i) numbers[{faces_[i].instance, faces_[i].face}] = i;
    hulls_.resize(count()), outlines_.resize(count()), curves_.resize(count());
    for (std::size_t i = 0; i < count(); ++i) {
        const Face& face = model().faces[faces_[i].face];
        const Affine& placed = model().instances[faces_[i].instance].transform;
        for (std::uint32_t k = 0; k < face.patch_count; ++k)
            for (const Vec4& p : model().patch(face.first_patch + k).points)
                hulls_[i].extend(euclidean(placed.homogeneous(p)));
    }
    for (const BoundaryInterval& border : borders.curves.all()) {
        const std::size_t i = numbers.at({border.instance, border.face});
        curves_[i].push_back(border);
        const SurfaceCurve curve = borders.curves.curve(border);
        for (const double t : {0.0, 0.5, 1.0}) outlines_[i].extend(curve.at(t).position);
    }
    tree_ = BoxTree(hulls_);
}

std::vector<Vec3> FaceTable::inner_places(std::size_t i) const {
    std::vector<Vec3> places;
    const Face& face = model().faces[faces_[i].face];
    const Affine& placed = model().instances[faces_[i].instance].transform;
    constexpr int steps = 5;
    each_material_place(model(), face, steps, [&](std::uint32_t patch, const Vec2& uv) {
        places.push_back(placed.point(evaluate(model().patch(patch), uv, 0).position()));
    });
    return places;
}

std::vector<std::size_t> FaceTable::around(std::size_t i, double reach) const {
    std::vector<std::size_t> around;
    if (outlines_[i].empty()) return around;
    for (const std::uint32_t k : tree_.overlapping(outlines_[i].padded(reach))) {
        const Box3 hull = hulls_[k].padded(reach);
        if (k != i && hull.contains(outlines_[i].lower) && hull.contains(outlines_[i].upper))
            around.push_back(k);
    }
    return around;
}

/// Tests the places of a face on others.
class LyingTest {
public:
    LyingTest(const FaceTable& table, std::size_t face, double limit)
        : table_(table), face_(face), limit_(limit), borders_(table.places_of_borders(face)) {}

    /// The face on another one; nullopt if a place of it is farther off than the limit.
    std::optional<IdenticalFaces> on(std::size_t other) {
        IdenticalFaces found;
        found.faces = {table_.face(face_), table_.face(other)}, found.limit = limit_;
        NearFace near(table_.model(), table_.face(other), limit_);
        if (!all_near(borders_, near, found)) return std::nullopt;
        if (inner_.empty()) inner_ = table_.inner_places(face_);
        if (!all_near(inner_, near, found)) return std::nullopt;
        return found;
    }

private:
    static bool all_near(const std::vector<Vec3>& places, NearFace& near, IdenticalFaces& found) {
        for (const Vec3& p : places) {
            const auto at = near.find(p);
            if (!at) return false;
            found.deep = found.deep || at->deep;
            if (at->distance < found.distance) continue;
            found.distance = at->distance, found.place = p;
        }
        return true;
    }

    const FaceTable& table_;
    std::size_t face_;
    double limit_;
    std::vector<Vec3> borders_;
    std::vector<Vec3> inner_; ///< made on first use
};

/// Joins what two faces are to each other.
std::vector<IdenticalFaces> listed_once(const std::vector<std::vector<IdenticalFaces>>& of_faces) {
    const auto is_reverse = [](const IdenticalFaces& a, const IdenticalFaces& b) {
        return a.faces[0] == b.faces[1] && a.faces[1] == b.faces[0];
    };
    std::vector<IdenticalFaces> all;
    for (const auto& some : of_faces)
        for (const IdenticalFaces& pair : some) {
            const auto known = std::find_if(all.begin(), all.end(), [&](const IdenticalFaces& k) {
                return is_reverse(k, pair);
            });
            if (known == all.end())
                all.push_back(pair);
            else
                known->mutual = true, known->deep = known->deep || pair.deep;
        }
    return all;
}

} // namespace

std::vector<IdenticalFaces> identical_faces(const ModelBorders& borders, const FaceLimits& limits,
                                            const Job& job) {
    const FaceTable table(borders);
    std::vector<std::vector<IdenticalFaces>> found(table.count());
    parallel_for(table.count(), job, "", [&](std::size_t i) {
        const auto& limit = limits.of(table.face(i)).structure.identical_face;
        if (!limit || !limits.in_scope(table.face(i))) return;
        const std::vector<std::size_t> around = table.around(i, *limit);
        if (around.empty()) return;
        LyingTest test(table, i, *limit);
        for (const std::size_t other : around)
            if (const auto lying = test.on(other)) found[i].push_back(*lying);
    });
    return listed_once(found);
}

} // namespace keiko
