#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/files/model/cad_text.h"
#include "keiko/import/cad/assembly.h"
#include "keiko/import/cad/cad_document.h"
#include "keiko/import/cad/iges_losses.h"
#include "keiko/import/cad/shape_attributes.h"
#include "keiko/import/cad/step_losses.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <unordered_map>

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

/// Takes the instances from the file's model space to the world. The scale is the length in model
/// space over that in the world [IGES5.3, 2.2.4.3.13]; OpenCASCADE passes over it.
void leave_model_space(IGESCAFControl_Reader& reader, CadDocument& document) {
    const double scale = reader.IGESModel()->GlobalSection().Scale();
    if (!std::isfinite(scale) || !(scale > 0) || scale == 1) return;
    for (CadInstance& instance : document.instances)
        instance.transform = Affine::scale(1 / scale) * instance.transform;
    std::ostringstream text;
    text << "its model space has a scale of " << scale << ": lengths are divided by it";
    document.diagnostics.push_back({Severity::warning, "", text.str()});
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
    MappedItems none;
    read_assembly(source, {}, none, document);
    leave_model_space(reader, document);
    note_iges_losses(reader, document);
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
