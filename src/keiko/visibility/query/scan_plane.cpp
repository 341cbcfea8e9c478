#include "keiko/visibility/query/scan_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace keiko {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A convex polygon in a piece's [-1, 1]^2, with some room for what pieces overlap by.
class Polygon {
public:
    Polygon() {
        constexpr double edge = 1 + 1e-6;
        for (const Vec2& corner :
             {Vec2(-edge, -edge), Vec2(edge, -edge), Vec2(edge, edge), Vec2(-edge, edge)})
            corners_[count_++] = corner;
    }
    /// Cuts away where c + x a + y b < 0.
    void cut(double a, double b, double c) {
        std::array<Vec2, capacity> kept;
        std::size_t count = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec2 &p = corners_[i], &q = corners_[(i + 1) % count_];
            const double at_p = c + a * p.x + b * p.y, at_q = c + a * q.x + b * q.y;
            if (at_p >= 0) kept[count++] = p;
            if ((at_p < 0) != (at_q < 0)) kept[count++] = p + (q - p) * (at_p / (at_p - at_q));
        }
        corners_ = kept;
        count_ = count;
    }
    auto begin() const { return corners_.begin(); }
    auto end() const { return corners_.begin() + static_cast<std::ptrdiff_t>(count_); }

private:
    /// Each of three cuts adds one; where corners are in line within rounding, more.
    static constexpr std::size_t capacity = 16;
    std::array<Vec2, capacity> corners_;
    std::size_t count_ = 0;
};

/// The range of x / z over the part of a convex set that lies before the viewpoint, z > 0.
/// It follows from bounds of the corners: x - c z is not negative anywhere if it is at no corner.
class QuotientRange {
public:
    void add(double x, double x_off, double z, double z_off) {
        low_ = std::min(low_, least(x, x_off, z, z_off));
        high_ = std::max(high_, -least(-x, x_off, z, z_off));
        behind_ = behind_ || !(z > z_off * 1.000001);
    }
    /// A corner behind the viewpoint tells nothing of what lies beyond zero.
    double low() const { return behind_ && low_ < 0 ? -infinity : low_; }
    double high() const { return behind_ && high_ > 0 ? infinity : high_; }

private:
    static double least(double x, double x_off, double z, double z_off) {
        const double least = x - x_off, depth = z + (least < 0 ? -z_off : z_off);
        if (depth > 0) return least / depth;
        return least < 0 ? -infinity : infinity;
    }

    double low_ = infinity, high_ = -infinity;
    bool behind_ = false;
};

/// With room for rounding, here and where segments are placed.
double roomy(double bound, double side) {
    constexpr double margin = 1e-9;
    return std::isfinite(bound) ? bound + side * margin * (1 + std::abs(bound)) : bound;
}

/// Gathers what places with errors may be.
class BoxBuilder {
public:
    void add(const Vec3& xyz, const Vec3& off) {
        along_.add(xyz.x, off.x, xyz.z, off.z);
        across_.add(xyz.y, off.y, xyz.z, off.z);
    }
    ScanBounds box() const {
        return {roomy(along_.low(), -1), roomy(along_.high(), 1), roomy(across_.low(), -1),
                roomy(across_.high(), 1)};
    }

private:
    QuotientRange along_, across_;
};

} // namespace

ScanPlane::ScanPlane(const Viewpoint& viewpoint, const Vec3& along, const Vec3& middle)
    : origin_(viewpoint.infinite() ? middle : viewpoint.place()),
      along_(along),
      parallel_(viewpoint.infinite()) {
    const Vec3 way = parallel_ ? viewpoint.place() : middle - origin_;
    const Vec3 across = way - along * along.dot(way);
    constexpr double end_on = 1e-6;
    regular_ = across.length() > end_on * way.length();
    z_ = across.normalized();
    y_ = along.cross(z_);
    x_ = parallel_ ? way.cross(y_).normalized() : along;
    if (x_.dot(along) < 0) x_ = -x_;
}

Vec4 ScanPlane::weights(const Vec3& direction, const Vec3& center) const {
    return {direction.x, direction.y, direction.z, direction.dot(center - origin_)};
}

Vec4 ScanPlane::depth_weights(const Vec3& center) const {
    return parallel_ ? Vec4(0, 0, 0, 1) : weights(z_, center);
}

ScreenPlace ScanPlane::place(const Vec3& x) const {
    const Vec3 way = x - origin_;
    const double depth = parallel_ ? 1 : z_.dot(way);
    return {x_.dot(way) / depth, y_.dot(way) / depth, depth};
}

bool ScanPlane::is_along(const Vec3& direction) const {
    constexpr double parallel = 1e-10; // rad, less than boxes have room for
    return direction.cross(along_).length() <= parallel * direction.length();
}

std::optional<ScanBounds> ScanPlane::hull(std::span<const Vec3> places) const {
    ScanBounds hull{infinity, -infinity, infinity, -infinity};
    for (const Vec3& x : places) {
        const ScreenPlace place = this->place(x);
        if (!(place.depth > 0)) return std::nullopt;
        hull.along_low = std::min(hull.along_low, place.along);
        hull.along_high = std::max(hull.along_high, place.along);
        hull.across_low = std::min(hull.across_low, place.across);
        hull.across_high = std::max(hull.across_high, place.across);
    }
    return hull;
}

ScanBounds ScanPlane::box(const SilhouettePiece& piece,
                          const AffineBounds::Weighed& edge_on) const {
    Polygon part;
    part.cut(edge_on.along_x, edge_on.along_y, edge_on.value + edge_on.off);
    part.cut(-edge_on.along_x, -edge_on.along_y, -edge_on.value + edge_on.off);
    const NetFrame& frame = piece.frame;
    const std::array nets{piece.points.weighed(frame.local(weights(x_, frame.center))),
                          piece.points.weighed(frame.local(weights(y_, frame.center))),
                          piece.points.weighed(frame.local(depth_weights(frame.center)))};
    const auto at = [&](std::size_t k, const Vec2& p) {
        return nets[k].value + p.x * nets[k].along_x + p.y * nets[k].along_y;
    };
    part.cut(nets[2].along_x, nets[2].along_y, nets[2].value + nets[2].off);
    if (part.begin() == part.end()) return {};
    BoxBuilder box;
    for (const Vec2& p : part)
        box.add({at(0, p), at(1, p), at(2, p)}, {nets[0].off, nets[1].off, nets[2].off});
    return box.box();
}

ScanBounds ScanPlane::box(const BoundaryPiece& border) const {
    const Vec3 way = border.center - origin_;
    BoxBuilder box;
    const Vec3 off(border.error, border.error, parallel_ ? 0 : border.error);
    for (const Vec3& point : border.curve) {
        const Vec3 p = way + point;
        box.add({x_.dot(p), y_.dot(p), parallel_ ? 1 : z_.dot(p)}, off);
    }
    return box.box();
}

namespace {

std::size_t bucket_count(std::size_t boxes) {
    return std::clamp<std::size_t>(boxes, 512, 4096);
}

} // namespace

BucketGrid::BucketGrid(std::vector<ScanBounds> boxes, double low, double high)
    : boxes_(std::move(boxes)),
      low_(low),
      per_width_(static_cast<double>(bucket_count(boxes_.size())) / std::max(high - low, 1e-12)),
      first_(bucket_count(boxes_.size()) + 1, 0) {
    const auto each_place = [&](const auto& visit) {
        for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
            if (boxes_[i].empty()) continue;
            const std::size_t last = bucket_of(boxes_[i].across_high);
            for (std::size_t b = bucket_of(boxes_[i].across_low); b <= last; ++b) visit(b, i);
        }
    };
    each_place([&](std::size_t bucket, std::uint32_t) { ++first_[bucket + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    members_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    each_place([&](std::size_t bucket, std::uint32_t box) { members_[next[bucket]++] = box; });
}

} // namespace keiko
