#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/files/model/cad_text.h"
#include "keiko/import/cad/assembly.h"
#include "keiko/import/cad/cad_document.h"
#include "keiko/import/cad/offset_bases.h"
#include "keiko/import/cad/shape_attributes.h"
#include "keiko/import/cad/step_losses.h"
#include "keiko/import/cad/surface_patches.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
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
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <unordered_map>
#include <unordered_set>

namespace keiko::cad {

CadDocument read_brep_file(const std::filesystem::path& path) {
    std::ifstream in(path);
    TopoDS_Shape shape;
    BRepTools::Read(shape, in, BRep_Builder());
    if (shape.IsNull()) throw Error(path.string(), "", "the BREP file is damaged or cut short");
    CadDocument document;
    document.parts.push_back({shape, path.stem().string(), {}});
    document.instances.push_back({0, path.stem().string(), {}});
    return document;
}

namespace {

std::string file_unit(IGESCAFControl_Reader& reader) {
    const auto model = reader.IGESModel();
    if (model.IsNull() || model->GlobalSection().UnitName().IsNull()) return "";
    TCollection_AsciiString unit = model->GlobalSection().UnitName()->String();
    unit.LowerCase();
    return unit.ToCString();
}

/// Entities that become faces where no other surface refers to them [IGES5.3].
bool is_surface(int type) {
    constexpr int types[] = {108, 114, 118, 120, 122, 128, 140, 143,
                             144, 190, 192, 194, 196, 198, 510};
    return std::find(std::begin(types), std::end(types), type) != std::end(types);
}

/// Solids and shells, which are nothing without faces.
bool must_hold_faces(int type) {
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
          document_(document) {}

    /// Whether an entity is a face or holds one, lost or not.
    bool look_into(const Entity& entity) {
        if (entity.IsNull()) return false;
        if (is_surface(entity->TypeNumber())) {
            if (seen_.insert(entity.get()).second) look_at_surface(entity);
            return true;
        }
        if (!seen_.insert(entity.get()).second) return false;
        bool holds = false;
        for (Interface_EntityIterator part = session_->Graph().Shareds(entity); part.More();
             part.Next())
            if (look_into(Entity::DownCast(part.Value()))) holds = true;
        if (!holds && must_hold_faces(entity->TypeNumber()) && shape_of(entity).IsNull())
            lose(entity);
        return holds;
    }

private:
    TopoDS_Shape shape_of(const Entity& entity) const {
        return TransferBRep::ShapeResult(process_, entity);
    }

    void look_at_surface(const Entity& entity) {
        const TopoDS_Shape shape = shape_of(entity);
        if (shape.IsNull()) lose(entity);
        const int stated = number_of_loops(entity), found = number_of_wires(shape);
        std::string lost;
        if (found < stated)
            lost = label(entity) + " states " + std::to_string(stated) + " trim loops, of which " +
                   std::to_string(found) + " were read";
        else
            lost = smoothed_offset(surface_of(entity), shape);
        if (lost.empty()) return;
        for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
            document_.misread.emplace(face.Current().TShape().get(), lost);
    }

    /// How the offset surface of a face differs from the file's; empty if it does not.
    std::string smoothed_offset(const Entity& surface, const TopoDS_Shape& shape) const {
        const auto stated = Handle(IGESGeom_OffsetSurface)::DownCast(surface);
        TopExp_Explorer face(shape, TopAbs_FACE);
        if (stated.IsNull() || !face.More()) return "";
        const auto read = Handle(Geom_OffsetSurface)::DownCast(
            untrimmed(BRep_Tool::Surface(TopoDS::Face(face.Current()))));
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

    void lose(const Entity& entity) {
        const std::string name = entity->HasShortLabel() ? entity->ShortLabel()->ToCString() : "";
        document_.lost_faces.push_back({name, label(entity) + " gave no face"});
    }

    Handle(XSControl_WorkSession) session_;
    Handle(Transfer_TransientProcess) process_;
    CadDocument& document_;
    std::unordered_set<const Standard_Transient*> seen_;
};

void note_iges_losses(IGESCAFControl_Reader& reader, CadDocument& document) {
    IgesLossReader losses(reader.WS(), document);
    for (int i = 1; i <= reader.NbRootsForTransfer(); ++i)
        losses.look_into(Handle(IGESData_IGESEntity)::DownCast(reader.RootForTransfer(i)));
}

} // namespace

CadDocument read_iges_file(const std::filesystem::path& path) {
    IGESCAFControl_Reader reader;
    reader.SetNameMode(true);
    reader.SetColorMode(true);
    reader.SetLayerMode(true);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        throw Error(path.string(), "", "not a readable IGES file");
    auto source = new_document();
    if (!reader.Transfer(source)) throw Error(path.string(), "", "the IGES file holds no shape");
    CadDocument document;
    document.unit = file_unit(reader);
    note_iges_losses(reader, document);
    MappedItems none;
    read_assembly(source, {}, none, document);
    const auto remarks = reader_remarks(reader.WS(), document.diagnostics);
    for (CadPart& part : document.parts) part.remarks_on = remarks;
    return document;
}

namespace {

std::string file_unit(STEPCAFControl_Reader& reader) {
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
    if (lengths.IsEmpty()) return "";
    TCollection_AsciiString unit = lengths.First();
    unit.LowerCase();
    return unit.ToCString();
}

/// Names and lines of the faces as the file has them. OpenCASCADE's own switch for face names
/// crashes on some files.
FaceLabels face_labels(const opencascade::handle<XSControl_WorkSession>& session,
                       const EntityLines& lines) {
    const auto process = session->TransferReader()->TransientProcess();
    const auto model = Handle(StepData_StepModel)::DownCast(session->Model());
    auto labels = std::make_shared<std::unordered_map<const TopoDS_TShape*, FaceLabel>>();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto face = Handle(StepShape_FaceSurface)::DownCast(model->Value(i));
        if (face.IsNull()) continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, face);
        if (shape.IsNull() || shape.ShapeType() != TopAbs_FACE) continue;
        const auto line = lines.find(static_cast<std::uint64_t>(model->IdentLabel(face)));
        labels->emplace(shape.TShape().get(),
                        FaceLabel{face->Name().IsNull() ? "" : face->Name()->ToCString(),
                                  line == lines.end() ? 0 : line->second});
    }
    return [labels](const TopoDS_Shape& face) {
        const auto found = labels->find(face.TShape().get());
        return found == labels->end() ? FaceLabel{} : found->second;
    };
}

/// Files that hold parts of the assembly but are not there or cannot be read, by name.
std::vector<std::string> missing_files(const STEPCAFControl_Reader& reader) {
    std::vector<std::string> names;
    using Files = NCollection_DataMap<TCollection_AsciiString, Handle(STEPCAFControl_ExternFile)>;
    for (Files::Iterator file(reader.ExternFiles()); file.More(); file.Next())
        if (file.Value()->GetLoadStatus() != IFSelect_RetDone || !file.Value()->GetTransferStatus())
            names.emplace_back(file.Key().ToCString());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace

CadDocument read_step_file(const std::filesystem::path& path) {
    STEPCAFControl_Reader reader;
    reader.SetNameMode(true);
    reader.SetColorMode(true);
    reader.SetLayerMode(true);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
        throw Error(path.string(), "", "not a readable STEP file");
    auto source = new_document();
    if (!reader.Transfer(source)) throw Error(path.string(), "", "the STEP file holds no shape");
    CadDocument document;
    document.unit = file_unit(reader);
    document.missing_files = missing_files(reader);
    const auto session = reader.Reader().WS();
    const EntityLines lines = step_entity_lines(read_file(path));
    MappedItems mapped(session);
    read_assembly(source, face_labels(session, lines), mapped, document);
    mapped.remark_unmet(document.diagnostics);
    note_step_losses(session, lines, document);
    for (const std::string& file : document.missing_files)
        document.lost_faces.push_back({file, "its file of parts cannot be read"});
    const auto remarks = reader_remarks(session, document.diagnostics);
    for (CadPart& part : document.parts) part.remarks_on = remarks;
    return document;
}

} // namespace keiko::cad
