#pragma once

#include "keiko/import/cad/step_kinds.h"

#include <XSControl_WorkSession.hxx>

#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace keiko::cad {

/// The entities that a walk from the shapes of a file downwards has met.
struct StepWalk {
    std::unordered_map<const Standard_Transient*, bool>
        holds; ///< each entity: whether it is a face or holds one, lost or not
    std::unordered_set<const Standard_Transient*> lost; ///< faces, and items without any

    /// Whether an entity that was met is a face or holds one.
    bool holds_face(const StepEntity& entity) const {
        const auto known = holds.find(entity.get());
        return known != holds.end() && known->second;
    }
};

/// The items of the representations that were met, and the elements of their geometric sets, that
/// have an area or a volume but gave no face, and below which nothing is lost. In file order.
std::vector<StepEntity> unread_items(const opencascade::handle<XSControl_WorkSession>& session,
                                     const StepWalk& walk);

} // namespace keiko::cad
