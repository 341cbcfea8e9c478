#pragma once

#include "keiko/import/subdivision/cage.h"
#include "keiko/math/bounds.h"
#include "keiko/math/vec.h"

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTable.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace keiko::subdivision {

namespace osd = OpenSubdiv;

/// The cage's faces, tags and rules as OpenSubdiv sees them. Throws Error, without a file, when
/// OpenSubdiv refuses them.
std::unique_ptr<osd::Far::TopologyRefiner> make_refiner(const Cage& cage);

/// An irregular vertex of the last level where the limit surface has a normal.
struct IrregularPoint {
    Vec3 position{0}; ///< relative to the table's centre
    Vec3 normal{0};   ///< unit vector
};

/// Offset that turns a cap at one of its corners into the limit surface's tangent plane there, and
/// leaves its border to the exact patches as it is: OpenSubdiv's Gregory patches come near that
/// plane only. Caps that share a border near the corner are moved alike along it.
struct CapTilt {
    int corner = -1;                 ///< anticlockwise from u = v = 0; -1: none
    Vec3 normal{0};                  ///< of the limit surface at the corner, unit vector
    double slope_x = 0, slope_y = 0; ///< of the cap along the two borders from the corner

    /// To be added to the cap at (u, v).
    Vec3 offset(double u, double v, bool triangle) const;
};

/// Finds irregular points by their place.
class IrregularPoints {
public:
    /// Sorts a copy of the points.
    explicit IrregularPoints(const std::vector<IrregularPoint>& points);

    /// The one within `reach` whose normal is nearest to `normal`, if any.
    const IrregularPoint* find(const Vec3& place, const Vec3& normal, double reach) const;

private:
    std::vector<std::pair<double, IrregularPoint>> sorted_; ///< by place along a direction
};

/// Levels of refinement that OpenSubdiv's tables can hold.
constexpr int deepest_level = 10;

/// A point of the limit surface with its two derivatives by the patch's parameters.
struct LimitPoint {
    Vec3 position{0};  ///< relative to the table's centre
    Vec3 du{0}, dv{0}; ///< first derivatives

    /// Unit normal, du x dv; the zero vector where the derivatives are parallel.
    Vec3 normal() const { return du.cross(dv).normalized(); }
};

/// Place of a patch of a table: its base face (an n-gon counts as n quads) and the box of its
/// parameters. A triangle covers the lower half of its box, a turned one the upper.
struct PatchPlace {
    std::uint32_t face = 0; ///< base face
    int level = 0;          ///< of refinement, from 0
    Box2 box;               ///< within [0, 1]^2 of the base face
    bool turned = false;    ///< of a triangle: both parameters run backwards

    /// Parameters of the base face at (u, v) of the patch.
    Vec2 base(double u, double v) const {
        const Vec2 size = box.extent();
        return turned ? box.upper - size * Vec2(u, v) : box.lower + size * Vec2(u, v);
    }
    /// Inverse of base.
    Vec2 local(const Vec2& uv) const {
        const Vec2 size = box.extent();
        return turned ? (box.upper - uv) / size : (uv - box.lower) / size;
    }
};

/// A cage refined around its irregular features down to a level, and the patches that
/// cover its limit surface: exact ones wherever it is a polynomial, caps in the last ring around
/// an irregular point. Coordinates relative to a centre, so that refinement keeps its digits.
class LimitTable {
public:
    /// Refines a cage down to a level. Throws Error, without a file, if OpenSubdiv refuses the
    /// cage.
    LimitTable(const Cage& cage, int level);

    /// How many points refining a cage makes on each level down to `level`.
    static std::vector<int> points_by_level(const Cage& cage, int level);

    /// Number of a patch: its array in OpenSubdiv's table, and its place there.
    struct Index {
        int array = 0; ///< patches of one kind
        int patch = 0; ///< within the array
    };
    /// All patches, array by array.
    std::vector<Index> patches() const;
    /// Patches that are not exact.
    std::vector<Index> caps() const;

    /// Centre of the box around all vertices of the cage, in units of the file.
    const Vec3& center() const { return center_; }
    /// True for a Loop cage, whose patches are triangles.
    bool triangular() const { return triangular_; }
    /// Place of a patch on the cage.
    PatchPlace place(Index index) const;
    /// Whether the patch is the limit surface itself, and no cap.
    bool exact(Index index) const;
    /// Sharpness of a crease of finite sharpness along one of its sides; 0: none.
    double crease_sharpness(Index index) const;
    /// Sides along which the patch ends at a border of the surface, as OpenSubdiv's bits: SideMask
    /// for a patch of four sides.
    unsigned border_mask(Index index) const;
    /// The control points of an exact patch of four sides.
    std::array<Vec3, 16> spline_net(Index index) const;
    /// By the patch's own parameters. For creases of finite sharpness it is not the limit surface;
    /// for caps it is near.
    LimitPoint evaluate(Index index, double u, double v) const;
    /// The patch at a place of a base face, if it is exact and beside no crease of finite
    /// sharpness.
    std::optional<Index> smooth_patch_at(std::uint32_t face, const Vec2& uv) const;

private:
    struct Value {
        Vec3 v;
        Value() : v(0) {}
        // NOLINTBEGIN(readability-identifier-naming): OpenSubdiv calls them by these names.
        void Clear() { v = Vec3(0); }
        void AddWithWeight(const Value& other, double weight) { v += other.v * weight; }
        // NOLINTEND(readability-identifier-naming)
    };

    void add_local_points(std::size_t first);
    void tilt_caps(const osd::Far::TopologyRefiner& refiner, const Value* last_level);
    CapTilt tilt_of(Index index, const IrregularPoints& points) const;
    LimitPoint evaluate_table(Index index, double u, double v) const;
    /// Among all patches.
    std::size_t position_of(Index index) const;
    osd::Far::PatchTable::PatchHandle handle(Index index) const;

    bool triangular_, has_creases_ = false;
    Vec3 center_{0};
    std::unique_ptr<osd::Far::PatchTable> table_;
    std::unique_ptr<osd::Far::PatchMap> map_;
    std::vector<Value> points_;
    std::vector<std::size_t> first_in_array_; ///< patches before each array
    std::vector<CapTilt> tilts_;              ///< of the patches from first_tilt_ on: the caps
    std::size_t first_tilt_ = 0;
};

} // namespace keiko::subdivision
