#include "keiko/import/cad/iges_losses.h"

#include "keiko/import/cad/offset_bases.h"
#include "keiko/import/cad/read_faces.h"

#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESGeom_BoundedSurface.hxx>
#include <IGESGeom_OffsetSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <IGESToBRep_BasicSurface.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <iterator>
#include <string>
#include <unordered_map>

namespace keiko::cad {

namespace {

/// Entities that become faces where no other surface refers to them [IGES5.3].
bool is_surface(int type) {
    constexpr int types[] = {108, 114, 118, 120, 122, 128, 140, 143,
                             144, 190, 192, 194, 196, 198, 510};
    return std::find(std::begin(types), std::end(types), type) != std::end(types);
}

/// Solids and shells: primitives, swept ones, Boolean trees, assemblies and copies of solids, and
/// those made of faces [IGES5.3].
bool is_body(int type) {
    constexpr int types[] = {150, 152, 154, 156, 158, 160, 162, 164, 168, 180, 184, 186, 430, 514};
    return std::find(std::begin(types), std::end(types), type) != std::end(types);
}

/// A solid or shell that lists its faces. Others are more than the bodies that they refer to.
bool is_made_of_faces(int type) {
    return type == 186 || type == 514;
}

/// Number of loops that a surface entity states for its trim.
int number_of_loops(const Handle(IGESData_IGESEntity) & entity) {
    if (const auto trimmed = Handle(IGESGeom_TrimmedSurface)::DownCast(entity); !trimmed.IsNull())
        return trimmed->NbInnerContours() + (trimmed->HasOuterContour() ? 1 : 0);
    if (const auto bounded = Handle(IGESGeom_BoundedSurface)::DownCast(entity); !bounded.IsNull())
        return bounded->NbBoundaries();
    if (const auto face = Handle(IGESSolid_Face)::DownCast(entity); !face.IsNull())
        return face->NbLoops();
    return 0;
}

/// The surface that a face lies on: itself where it has no trims.
Handle(IGESData_IGESEntity) surface_of(const Handle(IGESData_IGESEntity) & entity) {
    if (const auto trimmed = Handle(IGESGeom_TrimmedSurface)::DownCast(entity); !trimmed.IsNull())
        return trimmed->Surface();
    if (const auto bounded = Handle(IGESGeom_BoundedSurface)::DownCast(entity); !bounded.IsNull())
        return bounded->Surface();
    if (const auto face = Handle(IGESSolid_Face)::DownCast(entity); !face.IsNull())
        return face->Surface();
    return entity;
}

int number_of_wires(const TopoDS_Shape& shape) {
    int count = 0;
    for (TopExp_Explorer wire(shape, TopAbs_WIRE); wire.More(); wire.Next()) ++count;
    return count;
}

/// Finds what an IGES file has for a face, a trim loop or a body, but no shape was made of.
class IgesLossReader {
    using Entity = Handle(IGESData_IGESEntity);

public:
    IgesLossReader(const Handle(XSControl_WorkSession) & session, CadDocument& document)
        : session_(session),
          process_(session->TransferReader()->TransientProcess()),
          document_(document),
          faces_(document) {}

    /// Looks for losses in all that the file places. OpenCASCADE's roots leave out what is of a
    /// type that it does not know.
    void read(XSControl_Reader& reader) {
        for (int i = 1; i <= reader.NbRootsForTransfer(); ++i)
            look_into(Entity::DownCast(reader.RootForTransfer(i)));
        for (int i = 1; i <= session_->Model()->NbEntities(); ++i) {
            const auto entity = Entity::DownCast(session_->Model()->Value(i));
            if (!entity.IsNull() && (is_root(entity) || is_whole_body(entity))) look_into(entity);
        }
    }

private:
    /// A surface to which nothing refers.
    bool is_root(const Entity& entity) const {
        return is_surface(entity->TypeNumber()) &&
               session_->Graph().Sharings(entity).NbEntities() == 0;
    }

    /// A body that is no part of another.
    bool is_whole_body(const Entity& entity) const {
        if (!is_body(entity->TypeNumber())) return false;
        for (Interface_EntityIterator user = session_->Graph().Sharings(entity); user.More();
             user.Next())
            if (const auto of = Entity::DownCast(user.Value());
                !of.IsNull() && is_body(of->TypeNumber()))
                return false;
        return true;
    }

    /// Looks for losses in an entity and below; says whether there are any.
    bool look_into(const Entity& entity) {
        if (entity.IsNull()) return false;
        const auto [known, is_new] = lossy_.try_emplace(entity.get(), false);
        if (!is_new) return known->second;
        const bool lossy =
            is_surface(entity->TypeNumber()) ? look_at_surface(entity) : look_below(entity);
        return lossy_[entity.get()] = lossy;
    }

    TopoDS_Shape shape_of(const Entity& entity) const {
        return TransferBRep::ShapeResult(process_, entity);
    }

    bool look_below(const Entity& entity) {
        const int type = entity->TypeNumber();
        bool lossy = false;
        if (!is_body(type) || is_made_of_faces(type))
            for (Interface_EntityIterator part = session_->Graph().Shareds(entity); part.More();
                 part.Next())
                if (look_into(Entity::DownCast(part.Value()))) lossy = true;
        if (lossy || !is_body(type) || !shape_of(entity).IsNull()) return lossy;
        lose(entity, "gave no face");
        return true;
    }

    bool look_at_surface(const Entity& entity) {
        const TopoDS_Shape shape = shape_of(entity);
        if (!faces_.have_one_of(shape)) {
            lose(entity, shape.IsNull() ? "gave no face" : "is in no part that is placed");
            return true;
        }
        const int stated = number_of_loops(entity), found = number_of_wires(shape);
        std::string lost;
        if (found < stated)
            lost = label(entity) + " states " + std::to_string(stated) + " trim loops, of which " +
                   std::to_string(found) + " were read";
        else
            lost = smoothed_offset(surface_of(entity), shape);
        if (lost.empty()) return false;
        faces_.misread(shape, lost);
        return true;
    }

    /// How the offset surface of a face differs from the file's; empty if it does not.
    std::string smoothed_offset(const Entity& surface, const TopoDS_Shape& shape) const {
        const auto stated = Handle(IGESGeom_OffsetSurface)::DownCast(surface);
        if (stated.IsNull()) return "";
        const auto read = offset_surface_of(shape);
        IGESToBRep_BasicSurface reader;
        reader.SetModel(Handle(IGESData_IGESModel)::DownCast(session_->Model()));
        const auto base = reader.TransferBasicSurface(stated->Surface());
        if (read.IsNull() || base.IsNull()) return "";
        const double error = offset_error(*read, base);
        return error > offset_tolerance ? smoothed_by(label(surface), error) : "";
    }

    /// "entity D12 of type 144"
    std::string label(const Entity& entity) const {
        return std::string("entity ") + session_->Model()->StringLabel(entity)->ToCString() +
               " of type " + std::to_string(entity->TypeNumber());
    }

    void lose(const Entity& entity, const std::string& why) {
        const std::string name = entity->HasShortLabel() ? entity->ShortLabel()->ToCString() : "";
        document_.lost_faces.push_back({name, label(entity) + " " + why});
    }

    Handle(XSControl_WorkSession) session_;
    Handle(Transfer_TransientProcess) process_;
    CadDocument& document_;
    ReadFaces faces_;
    std::unordered_map<const Standard_Transient*, bool> lossy_; ///< look_into() of each
};

} // namespace

void note_iges_losses(XSControl_Reader& reader, CadDocument& document) {
    IgesLossReader(reader.WS(), document).read(reader);
}

} // namespace keiko::cad
