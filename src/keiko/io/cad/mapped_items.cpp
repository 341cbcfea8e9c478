#include "keiko/io/cad/mapped_items.h"

#include "keiko/io/cad/transforms.h"

#include <Interface_InterfaceModel.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepRepr_MappedItem.hxx>
#include <StepToGeom.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>

#include <algorithm>
#include <cmath>

namespace keiko::cad {
namespace {

using Operator = opencascade::handle<StepGeom_CartesianTransformationOperator3d>;

/// A mapped item that its operator mirrors or scales.
struct MappedItem {
    TopoDS_Shape as_read;
    gp_Trsf correction; ///< from where OpenCASCADE put it to where it belongs
    std::string label;  ///< of the entity
};

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

/// The operator as ISO 10303-42 defines it (base_axis, cartesian_transformation_operator_3d);
/// `rigid`, which holds its origin in mm, where its axes or its scale make no map.
gp_Trsf whole(const Operator& entity, const gp_Trsf& rigid) {
    gp_XYZ w = direction(entity->Axis3(), {0, 0, 1});
    gp_XYZ u = across(direction(entity->Axis1(), {1, 0, 0}), w);
    const double scale = entity->HasScale() ? entity->Scale() : 1;
    constexpr double least = 1e-6;
    if (u.Modulus() < least || !(scale > least && scale < 1 / least)) return rigid;
    u.Normalize();
    gp_XYZ v = across(across(direction(entity->Axis2(), {0, 1, 0}), w), u);
    if (v.Modulus() < least) return rigid;
    v.Normalize();
    u *= scale, v *= scale, w *= scale;
    const gp_XYZ& t = rigid.TranslationPart();
    gp_Trsf result;
    result.SetValues(u.X(), v.X(), w.X(), t.X(), u.Y(), v.Y(), w.Y(), t.Y(), u.Z(), v.Z(), w.Z(),
                     t.Z());
    return result;
}

std::vector<MappedItem> mirrored_or_scaled(
    const opencascade::handle<XSControl_WorkSession>& session) {
    const auto process = session->TransferReader()->TransientProcess();
    const auto model = session->Model();
    std::vector<MappedItem> items;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto item = Handle(StepRepr_MappedItem)::DownCast(model->Value(i));
        if (item.IsNull()) continue;
        const auto target = Operator::DownCast(item->MappingTarget());
        gp_Trsf rigid;
        if (target.IsNull() || !StepToGeom::MakeTransformation3d(target, rigid)) continue;
        const gp_Trsf wanted = whole(target, rigid);
        constexpr double rounding = 1e-9;
        if (std::abs(wanted.ScaleFactor() - 1) < rounding) continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, item);
        items.push_back({shape, wanted * rigid.Inverted(), model->StringLabel(item)->ToCString()});
    }
    return items;
}

/// Places one instance: those that stand where the item does and show its shape are alike.
bool place(CadDocument& document, const MappedItem& item) {
    if (item.as_read.IsNull()) return false;
    const Affine as_read = affine(item.as_read.Location().Transformation());
    for (CadInstance& instance : document.instances)
        if (document.parts[instance.part].shape.IsPartner(item.as_read) &&
            instance.transform == as_read) {
            instance.transform = affine(item.correction) * as_read;
            return true;
        }
    return false;
}

/// Whether the item also lies within a part, where it cannot be placed by itself.
bool lies_within_a_part(const CadDocument& document, const MappedItem& item) {
    return std::any_of(document.parts.begin(), document.parts.end(), [&](const CadPart& part) {
        TopTools_IndexedMapOfShape shapes;
        TopExp::MapShapes(part.shape, item.as_read.ShapeType(), shapes);
        return shapes.Contains(item.as_read) && !part.shape.IsPartner(item.as_read);
    });
}

} // namespace

void place_mapped_items(const opencascade::handle<XSControl_WorkSession>& session,
                        CadDocument& document) {
    for (const MappedItem& item : mirrored_or_scaled(session))
        if (!place(document, item) || lies_within_a_part(document, item))
            document.diagnostics.push_back(
                {Severity::warning, "entity " + item.label,
                 "mirrors or scales what it places; it is neither mirrored nor scaled here"});
}

} // namespace keiko::cad
