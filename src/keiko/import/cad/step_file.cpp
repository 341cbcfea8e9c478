#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/files/model/step_lines.h"
#include "keiko/import/cad/assembly.h"
#include "keiko/import/cad/cad_files.h"
#include "keiko/import/cad/mapped_items.h"
#include "keiko/import/cad/reader_remarks.h"

#include <IFSelect_ReturnStatus.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_TShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <memory>
#include <unordered_map>

namespace keiko::cad {
namespace {

std::string file_unit(STEPCAFControl_Reader& reader) {
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
    if (lengths.IsEmpty()) return "";
    TCollection_AsciiString unit = lengths.First();
    unit.LowerCase();
    return unit.ToCString();
}

/// Face entities of the file: names and lines of those that were translated, a remark on the
/// others. OpenCASCADE's own switch for face names crashes on some files.
FaceLabels face_labels(STEPCAFControl_Reader& reader, const std::filesystem::path& path,
                       Diagnostics& diagnostics) {
    const auto session = reader.Reader().WS();
    const auto process = session->TransferReader()->TransientProcess();
    const auto model = Handle(StepData_StepModel)::DownCast(session->Model());
    const auto lines = step_entity_lines(read_file(path));
    auto labels = std::make_shared<std::unordered_map<const TopoDS_TShape*, FaceLabel>>();
    int missing = 0;
    std::string numbers;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto face = Handle(StepShape_FaceSurface)::DownCast(model->Value(i));
        if (face.IsNull()) continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, face);
        if (shape.IsNull()) {
            if (++missing <= 10)
                numbers += " " + std::string(model->StringLabel(face)->ToCString());
        } else if (shape.ShapeType() == TopAbs_FACE) {
            const auto line = lines.find(static_cast<std::uint64_t>(model->IdentLabel(face)));
            labels->emplace(shape.TShape().get(),
                            FaceLabel{face->Name().IsNull() ? "" : face->Name()->ToCString(),
                                      line == lines.end() ? 0 : line->second});
        }
    }
    if (missing > 0)
        diagnostics.push_back(
            {Severity::warning, "",
             std::to_string(missing) + " face entities of the file gave no face:" + numbers});
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
    MappedItems mapped(reader.Reader().WS());
    read_assembly(source, face_labels(reader, path, document.diagnostics), mapped, document);
    mapped.remark_unmet(document.diagnostics);
    const auto remarks = reader_remarks(reader.Reader().WS(), document.diagnostics);
    for (CadPart& part : document.parts) part.remarks_on = remarks;
    return document;
}

} // namespace keiko::cad
