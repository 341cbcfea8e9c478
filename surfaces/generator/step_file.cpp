#include "step_file.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

namespace keiko::fixtures {
namespace {

Handle(TCollection_HAsciiString) text(const std::string& string) {
    return new TCollection_HAsciiString(string.c_str());
}

/// Numbers the faces by connected part: faces that share an edge get the same number.
std::vector<std::size_t> part_numbers(const std::vector<NamedFace>& faces) {
    std::vector<std::size_t> part(faces.size());
    std::iota(part.begin(), part.end(), std::size_t{0});
    TopTools_DataMapOfShapeInteger first_face;
    for (std::size_t k = 0; k < faces.size(); ++k)
        for (TopExp_Explorer edge(faces[k].face, TopAbs_EDGE); edge.More(); edge.Next()) {
            const int* known = first_face.Seek(edge.Current());
            if (known == nullptr) {
                first_face.Bind(edge.Current(), static_cast<int>(k));
                continue;
            }
            const std::size_t keep = part[static_cast<std::size_t>(*known)];
            std::replace(part.begin(), part.end(), std::size_t{part[k]}, keep);
        }
    return part;
}

/// A compound of shells, one for each connected part, in the order of their first faces.
TopoDS_Compound body_of(const std::vector<NamedFace>& faces) {
    const BRep_Builder builder;
    const std::vector<std::size_t> part = part_numbers(faces);
    std::map<std::size_t, TopoDS_Shell> shells;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        TopoDS_Shell& shell = shells[part[k]];
        if (shell.IsNull()) builder.MakeShell(shell);
        builder.Add(shell, faces[k].face);
    }
    TopoDS_Compound body;
    builder.MakeCompound(body);
    for (const auto& [number, shell] : shells) builder.Add(body, shell);
    return body;
}

/// STEPControl forgets names, but it remembers which entity a face became.
void name_faces(const STEPControl_Writer& writer, const std::vector<NamedFace>& faces) {
    const Handle(Transfer_FinderProcess) finder = writer.WS()->TransferWriter()->FinderProcess();
    for (const NamedFace& named : faces) {
        const Handle(TransferBRep_ShapeMapper) mapper =
            TransferBRep::ShapeMapper(finder, named.face);
        Handle(Standard_Transient) item;
        if (!finder->FindTypedTransient(mapper, STANDARD_TYPE(StepRepr_RepresentationItem), item))
            throw std::runtime_error("face " + named.name + " was not written");
        Handle(StepRepr_RepresentationItem)::DownCast(item)->SetName(text(named.name));
    }
}

void fix_header(STEPControl_Writer& writer, const std::string& name) {
    APIHeaderSection_MakeHeader header(writer.Model());
    header.SetName(text(name));
    header.SetTimeStamp(text("2000-01-01T00:00:00"));
    header.SetAuthorValue(1, text("keiko-fixtures"));
    header.SetOrganizationValue(1, text("Keiko"));
    header.SetOriginatingSystem(text("keiko-fixtures"));
    header.SetPreprocessorVersion(text("Open CASCADE STEP translator"));
    header.SetAuthorisation(text(""));
    header.SetDescriptionValue(1, text("Fixture of Keiko, written by surfaces/generator"));
}

} // namespace

void write_step(const std::filesystem::path& file, const std::vector<NamedFace>& faces) {
    const TopoDS_Compound body = body_of(faces);
    const std::string name = file.stem().string();
    if (!BRepCheck_Analyzer(body).IsValid())
        throw std::runtime_error(name + ": BRepCheck finds the body invalid");
    // The translator chats on the console.
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.schema", "AP214IS");
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetCVal("write.step.product.name", name.c_str());
    if (writer.Transfer(body, STEPControl_ShellBasedSurfaceModel) != IFSelect_RetDone)
        throw std::runtime_error(name + ": cannot be put into STEP");
    name_faces(writer, faces);
    fix_header(writer, name + ".step");
    if (writer.Write(file.string().c_str()) != IFSelect_RetDone)
        throw std::runtime_error("cannot write " + file.string());
}

} // namespace keiko::fixtures
