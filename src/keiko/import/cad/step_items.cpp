#include "keiko/import/cad/step_items.h"

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <StepRepr_Representation.hxx>
#include <StepShape_GeometricSet.hxx>
#include <StepVisual_TessellatedGeometricSet.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>

#include <set>

namespace keiko::cad {

namespace {

/// Entities whose items, or elements, are shapes each by itself.
bool lists_shapes(const StepEntity& entity) {
    return is_a<StepRepr_Representation>(entity) || is_a<StepShape_GeometricSet>(entity) ||
           is_a<StepVisual_TessellatedGeometricSet>(entity) ||
           is_unknown_shape_representation(entity);
}

class ItemReader {
public:
    ItemReader(const opencascade::handle<XSControl_WorkSession>& session, const StepWalk& walk)
        : graph_(session->Graph()),
          process_(session->TransferReader()->TransientProcess()),
          walk_(walk) {}

    std::vector<StepEntity> unread() {
        const auto& model = graph_.Model();
        for (int i = 1; i <= model->NbEntities(); ++i)
            if (walk_.holds.count(model->Value(i).get()) > 0 && lists_shapes(model->Value(i)))
                take_items(model->Value(i));
        return std::move(unread_);
    }

private:
    void take_items(const StepEntity& list) {
        for (Interface_EntityIterator item = graph_.Shareds(list); item.More(); item.Next()) {
            std::set<const Standard_Transient*> seen;
            if (seen_.insert(item.Value().get()).second && has_area(item.Value()) &&
                !gave_face(item.Value()) && !is_told_by_faces(item.Value()) &&
                !lost_below(item.Value(), seen))
                unread_.push_back(item.Value());
        }
    }

    bool gave_face(const StepEntity& item) const {
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process_, item);
        return TopExp_Explorer(shape, TopAbs_FACE).More();
    }

    /// Whether the faces that an item refers to are all of it. Triangles are so if they are linked
    /// with the exact shape, each by itself or the whole.
    bool is_told_by_faces(const StepEntity& item) const {
        if (!walk_.holds_face(item)) return false;
        if (!is_tessellated(item)) return is_made_of_faces(item);
        bool all = true;
        for (Interface_EntityIterator part = graph_.Shareds(item); part.More(); part.Next()) {
            if (is_tessellated(part.Value()))
                all = all && is_told_by_faces(part.Value());
            else if (walk_.holds_face(part.Value()))
                return true;
        }
        return all;
    }

    bool lost_below(const StepEntity& entity, std::set<const Standard_Transient*>& seen) const {
        if (walk_.lost.count(entity.get()) > 0) return true;
        if (!seen.insert(entity.get()).second) return false;
        for (Interface_EntityIterator part = graph_.Shareds(entity); part.More(); part.Next())
            if (lost_below(part.Value(), seen)) return true;
        return false;
    }

    const Interface_Graph& graph_;
    opencascade::handle<Transfer_TransientProcess> process_;
    const StepWalk& walk_;
    std::set<const Standard_Transient*> seen_;
    std::vector<StepEntity> unread_;
};

} // namespace

std::vector<StepEntity> unread_items(const opencascade::handle<XSControl_WorkSession>& session,
                                     const StepWalk& walk) {
    return ItemReader(session, walk).unread();
}

} // namespace keiko::cad
