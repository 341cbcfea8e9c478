#include "keiko/import/cad/step_losses.h"

#include "keiko/import/cad/offset_bases.h"
#include "keiko/import/cad/read_faces.h"
#include "keiko/import/cad/step_items.h"

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionRelationship.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_UndefinedEntity.hxx>
#include <StepGeom_OffsetSurface.hxx>
#include <StepGeom_Surface.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_ProductDefinitionShape.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationRelationshipWithTransformation.hxx>
#include <StepRepr_ShapeRepresentationRelationship.hxx>
#include <StepShape_ContextDependentShapeRepresentation.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_VertexLoop.hxx>
#include <StepToGeom.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>

#include <cmath>
#include <set>
#include <utility>

namespace keiko::cad {

namespace {

using Entity = StepEntity;
using FaceEntity = opencascade::handle<StepShape_FaceSurface>;

/// Entities by which a file says that something is a shape. Presentation and features of a shape
/// refer to faces, too, but make no material of them.
bool states_shape(const Entity& entity) {
    return is_a<StepShape_ShapeRepresentation>(entity) ||
           is_a<StepShape_ShapeDefinitionRepresentation>(entity) ||
           is_a<StepRepr_ShapeRepresentationRelationship>(entity) ||
           is_unknown_shape_representation(entity);
}

class StepLossReader {
    using Usage = opencascade::handle<StepRepr_NextAssemblyUsageOccurrence>;
    using Placement = opencascade::handle<StepShape_ContextDependentShapeRepresentation>;
    using Movement = opencascade::handle<StepRepr_RepresentationRelationshipWithTransformation>;

public:
    StepLossReader(const opencascade::handle<XSControl_WorkSession>& session,
                   const EntityLines& lines, CadDocument& document)
        : session_(session),
          graph_(session->Graph()),
          process_(session->TransferReader()->TransientProcess()),
          model_(opencascade::handle<StepData_StepModel>::DownCast(session->Model())),
          lines_(lines),
          document_(document),
          faces_(document) {}

    void read() {
        for (int i = 1; i <= model_->NbEntities(); ++i)
            if (states_shape(model_->Value(i))) look_into(model_->Value(i));
        for (int i = 1; i <= model_->NbEntities(); ++i) {
            const Entity entity = model_->Value(i);
            if (const auto face = FaceEntity::DownCast(entity); !face.IsNull()) take(face);
            if (const auto usage = Usage::DownCast(entity); !usage.IsNull()) take(usage);
            if (const auto placement = Placement::DownCast(entity); !placement.IsNull())
                take(placement);
        }
        for (const Entity& item : unread_items(session_, walk_))
            lose(item, "of kind " + kind_of(item, model_) + " gave no face");
        remark_unused();
    }

private:
    TopoDS_Shape shape_of(const Entity& entity) const {
        return entity.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(process_, entity);
    }

    /// "#12 in line 34"
    std::string label(const Entity& entity) const {
        const std::string number = model_->StringLabel(entity)->ToCString();
        const auto line = lines_.find(static_cast<std::uint64_t>(model_->IdentLabel(entity)));
        return line == lines_.end() ? number : number + " in line " + std::to_string(line->second);
    }

    void lose(const Entity& entity, const std::string& why) {
        walk_.lost.insert(entity.get());
        const auto face = FaceEntity::DownCast(entity);
        const bool named = !face.IsNull() && !face->Name().IsNull();
        document_.lost_faces.push_back(
            {named ? face->Name()->ToCString() : "", label(entity) + " " + why});
    }

    /// Whether an entity is a face or holds one, lost or not. Faces met are used as material; what
    /// has to hold faces but neither holds nor became one is lost.
    bool look_into(const Entity& entity) {
        const auto [known, is_new] =
            walk_.holds.try_emplace(entity.get(), is_a<StepShape_FaceSurface>(entity));
        if (!is_new || known->second) return known->second;
        bool holds = false;
        for (Interface_EntityIterator part = graph_.Shareds(entity); part.More(); part.Next())
            if (look_into(part.Value())) holds = true;
        if (!holds && must_hold_faces(entity) && !gave_face(entity)) {
            lose(entity, "of kind " + kind_of(entity, model_) + " holds no face");
            holds = true;
        }
        return walk_.holds[entity.get()] = holds;
    }

    bool gave_face(const Entity& entity) const {
        return TopExp_Explorer(shape_of(entity), TopAbs_FACE).More();
    }

    void take(const FaceEntity& face) {
        const TopoDS_Shape shape = shape_of(face);
        if (faces_.have_one_of(shape)) {
            std::string lost = lost_bound(face);
            if (lost.empty()) lost = smoothed_offset(face, shape);
            if (!lost.empty()) faces_.misread(shape, lost);
        } else if (walk_.holds.count(face.get()) > 0) {
            lose(face, shape.IsNull() ? "gave no face" + on_surface(face)
                                      : "is in no part that is placed");
        } else if (shape.IsNull() && ++unused_ <= 10) {
            unused_labels_ += std::string(" ") + model_->StringLabel(face)->ToCString();
        }
    }

    /// "; its surface is #12 of kind PLANE", or empty.
    std::string on_surface(const FaceEntity& face) const {
        Entity surface = face->FaceGeometry();
        for (Interface_EntityIterator part = graph_.Shareds(face); surface.IsNull() && part.More();
             part.Next())
            if (is_a<StepData_UndefinedEntity>(part.Value())) surface = part.Value();
        if (surface.IsNull()) return "";
        return std::string("; its surface is ") + model_->StringLabel(surface)->ToCString() +
               " of kind " + kind_of(surface, model_);
    }

    /// Which bound of a face was not translated; empty if all were.
    std::string lost_bound(const FaceEntity& face) const {
        for (int i = 1; i <= face->NbBounds(); ++i) {
            const auto bound = face->BoundsValue(i);
            const std::string lost =
                bound.IsNull() ? "is of a kind that is not known" : lost_part(bound->Bound());
            if (!lost.empty())
                return "bound " + (bound.IsNull() ? std::to_string(i) : label(bound)) + " " + lost;
        }
        return "";
    }

    /// How the offset surface of a face differs from the file's; empty if it does not.
    std::string smoothed_offset(const FaceEntity& face, const TopoDS_Shape& shape) const {
        const auto stated =
            opencascade::handle<StepGeom_OffsetSurface>::DownCast(face->FaceGeometry());
        if (stated.IsNull()) return "";
        const auto read = offset_surface_of(shape);
        const auto base = StepToGeom::MakeSurface(stated->BasisSurface());
        if (read.IsNull() || base.IsNull()) return "";
        // The unit of the last shape that was read need not be that of this face: what is measured
        // is read again.
        const auto again =
            opencascade::handle<Geom_OffsetSurface>::DownCast(StepToGeom::MakeSurface(stated));
        if (again.IsNull() || again->Offset() == 0) return "";
        const double error =
            offset_error(*again, base) * std::abs(read->Offset() / again->Offset());
        return error > offset_tolerance ? smoothed_by(label(stated), error) : "";
    }

    /// A vertex loop bounds nothing.
    std::string lost_part(const opencascade::handle<StepShape_Loop>& loop) const {
        if (is_a<StepShape_VertexLoop>(loop)) return "";
        if (const auto edges = opencascade::handle<StepShape_EdgeLoop>::DownCast(loop);
            !edges.IsNull())
            for (int i = 1; i <= edges->NbEdgeList(); ++i)
                if (!is_translated(edges->EdgeListValue(i)))
                    return "lacks edge " + std::to_string(i) + " of its loop " + label(loop);
        return shape_of(loop).IsNull() ? "gave no trim loop" : "";
    }

    bool is_translated(const opencascade::handle<StepShape_OrientedEdge>& oriented) const {
        if (oriented.IsNull() || shape_of(oriented->EdgeElement()).IsNull()) return false;
        const auto edge =
            opencascade::handle<StepShape_EdgeCurve>::DownCast(oriented->EdgeElement());
        return edge.IsNull() || !edge->EdgeGeometry().IsNull();
    }

    void take(const Usage& usage) {
        std::set<const Standard_Transient*> seen;
        if (shape_of(usage).IsNull())
            lose_product(usage->RelatedProductDefinition(),
                         "is not placed by occurrence " + label(usage), seen);
    }

    /// A place whose occurrence or transformation is unknown: OpenCASCADE leaves the part out, or
    /// at its own origin.
    void take(const Placement& placement) {
        const auto usage = placement->RepresentedProductRelation();
        const auto relation = placement->RepresentationRelation();
        if (relation.IsNull()) return; // its occurrence has no shape
        const bool is_known = !usage.IsNull() && !usage->Definition().Value().IsNull() &&
                              !usage->Definition().ProductDefinitionRelationship().IsNull();
        const auto moving = Movement::DownCast(relation);
        const Entity way =
            moving.IsNull() ? Entity(relation) : moving->TransformationOperator().Value();
        const bool is_moved = !way.IsNull() && !is_a<StepData_UndefinedEntity>(way);
        std::set<const Standard_Transient*> seen;
        if (!is_known || !is_moved)
            lose_representation(relation->Rep1(), "has no known place by " + label(placement),
                                seen);
    }

    /// Loses the faces of a product, of its representations and of the products in it.
    void lose_product(const Entity& product, const std::string& why,
                      std::set<const Standard_Transient*>& seen) {
        if (product.IsNull() || !seen.insert(product.get()).second) return;
        for (Interface_EntityIterator user = graph_.Sharings(product); user.More(); user.Next()) {
            if (const auto usage = Usage::DownCast(user.Value()); !usage.IsNull()) {
                if (usage->RelatingProductDefinition() == product)
                    lose_product(usage->RelatedProductDefinition(), why, seen);
            } else if (is_a<StepRepr_ProductDefinitionShape>(user.Value())) {
                lose_shown(user.Value(), why, seen);
            }
        }
    }

    /// Whether the entity that shows a product's shape is known or not, it refers to what it shows.
    void lose_shown(const Entity& shape, const std::string& why,
                    std::set<const Standard_Transient*>& seen) {
        for (Interface_EntityIterator user = graph_.Sharings(shape); user.More(); user.Next()) {
            if (!is_a<StepShape_ShapeDefinitionRepresentation>(user.Value()) &&
                !is_a<StepData_UndefinedEntity>(user.Value()))
                continue;
            for (Interface_EntityIterator shown = graph_.Shareds(user.Value()); shown.More();
                 shown.Next())
                if (is_a<StepRepr_Representation>(shown.Value()))
                    lose_representation(shown.Value(), why, seen);
        }
    }

    /// Also of those that it is related to without a place of their own.
    void lose_representation(const Entity& representation, const std::string& why,
                             std::set<const Standard_Transient*>& seen) {
        if (representation.IsNull() || seen.count(representation.get()) > 0) return;
        lose_below(representation, why, seen);
        for (Interface_EntityIterator user = graph_.Sharings(representation); user.More();
             user.Next()) {
            const auto relation =
                opencascade::handle<StepRepr_ShapeRepresentationRelationship>::DownCast(
                    user.Value());
            if (relation.IsNull() || !Movement::DownCast(relation).IsNull()) continue;
            lose_representation(relation->Rep1(), why, seen);
            lose_representation(relation->Rep2(), why, seen);
        }
    }

    void lose_below(const Entity& entity, const std::string& why,
                    std::set<const Standard_Transient*>& seen) {
        if (!seen.insert(entity.get()).second) return;
        if (is_a<StepShape_FaceSurface>(entity)) {
            if (walk_.lost.count(entity.get()) == 0) lose(entity, why);
            return;
        }
        for (Interface_EntityIterator part = graph_.Shareds(entity); part.More(); part.Next())
            lose_below(part.Value(), why, seen);
    }

    void remark_unused() const {
        if (unused_ > 0)
            document_.diagnostics.push_back(
                {Severity::warning, "",
                 std::to_string(unused_) +
                     " face entities that no shape of the file refers to gave no face:" +
                     unused_labels_});
    }

    opencascade::handle<XSControl_WorkSession> session_;
    const Interface_Graph& graph_;
    opencascade::handle<Transfer_TransientProcess> process_;
    opencascade::handle<StepData_StepModel> model_;
    const EntityLines& lines_;
    CadDocument& document_;
    ReadFaces faces_;
    StepWalk walk_;
    int unused_ = 0;
    std::string unused_labels_;
};

} // namespace

void note_step_losses(const opencascade::handle<XSControl_WorkSession>& session,
                      const EntityLines& lines, CadDocument& document) {
    StepLossReader(session, lines, document).read();
}

} // namespace keiko::cad
