#include "keiko/math/affine.h"

#include <cmath>

namespace keiko {

Vec3 Affine::normal(const Vec3& n) const {
    return {rows[1].cross(rows[2]).dot(n), rows[2].cross(rows[0]).dot(n),
            rows[0].cross(rows[1]).dot(n)};
}

Vec4 Affine::homogeneous(const Vec4& p) const {
    const Vec3 moved = vector({p.x, p.y, p.z}) + translation * p.w;
    return {moved.x, moved.y, moved.z, p.w};
}

Affine Affine::inverse() const {
    const double scale = 1 / determinant();
    const Vec3 c0 = rows[1].cross(rows[2]) * scale;
    const Vec3 c1 = rows[2].cross(rows[0]) * scale;
    const Vec3 c2 = rows[0].cross(rows[1]) * scale;
    Affine result;
    result.rows = {Vec3(c0.x, c1.x, c2.x), Vec3(c0.y, c1.y, c2.y), Vec3(c0.z, c1.z, c2.z)};
    result.translation = -result.vector(translation);
    return result;
}

Affine operator*(const Affine& a, const Affine& b) {
    Affine product;
    for (std::size_t i = 0; i < 3; ++i)
        product.rows[i] =
            b.rows[0] * a.rows[i].x + b.rows[1] * a.rows[i].y + b.rows[2] * a.rows[i].z;
    product.translation = a.point(b.translation);
    return product;
}

Affine Affine::rotate(const Vec3& axis, double radians) {
    const Vec3 k = axis.normalized();
    const double c = std::cos(radians), s = std::sin(radians), d = 1 - c;
    Affine result;
    result.rows = {Vec3(c + k.x * k.x * d, k.x * k.y * d - k.z * s, k.x * k.z * d + k.y * s),
                   Vec3(k.y * k.x * d + k.z * s, c + k.y * k.y * d, k.y * k.z * d - k.x * s),
                   Vec3(k.z * k.x * d - k.y * s, k.z * k.y * d + k.x * s, c + k.z * k.z * d)};
    return result;
}

Affine Affine::scale(double factor) {
    Affine result;
    for (Vec3& row : result.rows) row *= factor;
    return result;
}

Box3 transformed(const Affine& map, const Box3& box) {
    Box3 result;
    for (int corner = 0; corner < 8; ++corner)
        result.extend(map.point({(corner & 1 ? box.upper : box.lower).x,
                                 (corner & 2 ? box.upper : box.lower).y,
                                 (corner & 4 ? box.upper : box.lower).z}));
    return result;
}

} // namespace keiko
