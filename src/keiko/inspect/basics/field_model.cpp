#include "keiko/inspect/basics/field_model.h"

#include <type_traits>

namespace keiko {
namespace {

/// False only if the function is nowhere above 0.
bool may_be_positive(const TaylorModel& model) {
    return !(peak(model).bound < 0);
}

} // namespace

FieldModel::FieldModel(const PatchBox& box, const LineField& field, double shift)
    : field_(field),
      shift_(shift),
      rational_(box.view().rational()),
      patch_(patch_model(box.view(), box.rounding())),
      values_(ratio<TaylorModel>(field, shift)) {}

bool FieldModel::may_face_plane() const {
    return may_be_positive(values_.ahead);
}

bool FieldModel::may_meet(const LineField& other, double low, double high) const {
    const LineRatio<TaylorModel> value = ratio<TaylorModel>(other, low);
    // The denominator has either sign, its square has one.
    return may_be_positive(value.above * value.below) &&
           may_be_positive(-value.residual(high - low) * value.below);
}

bool FieldModel::may_be_singular() const {
    const Triple<TaylorModel> n = normal<TaylorModel>();
    return may_vanish(n.x) && may_vanish(n.y) && may_vanish(n.z);
}

template <class T>
T FieldModel::of(const TaylorModel& f, const TaylorModel& x, const TaylorModel& y) const {
    if constexpr (std::is_same_v<T, TaylorModel>)
        return f;
    else
        return {f, x, y};
}

/// S_x x S_y or, of a rational patch with S = p / w, that times w^3: the derivatives of the weight
/// occur but once in each of its terms.
template <class T>
Triple<T> FieldModel::normal() const {
    const PatchModel& m = patch_;
    const Triple<T> x = point<T>(m.x, m.xx, m.xy), y = point<T>(m.y, m.xy, m.yy);
    if (!rational_) return cross(x, y);
    const Triple<T> p = point<T>(m.s, m.x, m.y);
    const T w = of<T>(m.s.w, m.x.w, m.y.w);
    return cross(x, y) * w - cross(p, y) * of<T>(m.x.w, m.xx.w, m.xy.w) -
           cross(x, p) * of<T>(m.y.w, m.xy.w, m.yy.w);
}

template <class T>
LineRatio<T> FieldModel::ratio(const LineField& field, double shift) const {
    const PatchModel& m = patch_;
    const Triple<T> place = point<T>(m.s, m.x, m.y);
    if (!rational_) return field.ratio(place, normal<T>(), shift);
    return field.ratio(place, normal<T>(), shift, of<T>(m.s.w, m.x.w, m.y.w));
}

template LineRatio<Jet<TaylorModel>> FieldModel::ratio(const LineField& field, double shift) const;

} // namespace keiko
