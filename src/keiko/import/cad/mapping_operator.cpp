#include "keiko/import/cad/mapping_operator.h"

#include <StepGeom_Direction.hxx>

namespace keiko::cad {
namespace {

using Operator = StepGeom_CartesianTransformationOperator3d;

gp_XYZ direction(const opencascade::handle<StepGeom_Direction>& entity, const gp_XYZ& otherwise) {
    if (entity.IsNull() || entity->NbDirectionRatios() != 3) return otherwise;
    const gp_XYZ d(entity->DirectionRatiosValue(1), entity->DirectionRatiosValue(2),
                   entity->DirectionRatiosValue(3));
    return d.Modulus() > 0 ? d.Normalized() : otherwise;
}

/// `d` made perpendicular to a unit vector.
gp_XYZ across(const gp_XYZ& d, const gp_XYZ& axis) {
    return d - axis * d.Dot(axis);
}

} // namespace

opencascade::handle<Operator> mapping_operator(
    const opencascade::handle<StepRepr_MappedItem>& item) {
    return opencascade::handle<Operator>::DownCast(item->MappingTarget());
}

gp_Trsf whole(const opencascade::handle<Operator>& mapping, const gp_Trsf& rigid) {
    gp_XYZ w = direction(mapping->Axis3(), {0, 0, 1});
    gp_XYZ u = across(direction(mapping->Axis1(), {1, 0, 0}), w);
    const double scale = mapping->HasScale() ? mapping->Scale() : 1;
    constexpr double least = 1e-6;
    if (u.Modulus() < least || !(scale > least && scale < 1 / least)) return rigid;
    u.Normalize();
    gp_XYZ v = across(across(direction(mapping->Axis2(), {0, 1, 0}), w), u);
    if (v.Modulus() < least) return rigid;
    v.Normalize();
    u *= scale, v *= scale, w *= scale;
    const gp_XYZ& t = rigid.TranslationPart();
    gp_Trsf result;
    result.SetValues(u.X(), v.X(), w.X(), t.X(), u.Y(), v.Y(), w.Y(), t.Y(), u.Z(), v.Z(), w.Z(),
                     t.Z());
    return result;
}

} // namespace keiko::cad
