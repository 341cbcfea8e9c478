#include "keiko/base/error.h"
#include "keiko/import/cad/assembly.h"
#include "keiko/import/cad/cad_files.h"
#include "keiko/import/cad/reader_remarks.h"

#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <iterator>

namespace keiko::cad {
namespace {

std::string file_unit(IGESCAFControl_Reader& reader) {
    const auto model = reader.IGESModel();
    if (model.IsNull() || model->GlobalSection().UnitName().IsNull()) return "";
    TCollection_AsciiString unit = model->GlobalSection().UnitName()->String();
    unit.LowerCase();
    return unit.ToCString();
}

bool is_surface(int type) {
    constexpr int types[] = {108, 114, 118, 120, 122, 128, 140, 143, 144,
                             186, 190, 192, 194, 196, 198, 510, 514};
    return std::find(std::begin(types), std::end(types), type) != std::end(types);
}

/// Tells which surfaces of the file gave no shape.
void note_untranslated(IGESCAFControl_Reader& reader, Diagnostics& diagnostics) {
    const auto process = reader.WS()->TransferReader()->TransientProcess();
    int missing = 0;
    std::string labels;
    for (int i = 1; i <= reader.NbRootsForTransfer(); ++i) {
        const auto root = Handle(IGESData_IGESEntity)::DownCast(reader.RootForTransfer(i));
        if (root.IsNull() || !is_surface(root->TypeNumber())) continue;
        if (!TransferBRep::ShapeResult(process, root).IsNull()) continue;
        if (++missing <= 10)
            labels += " " + std::string(reader.WS()->Model()->StringLabel(root)->ToCString());
    }
    if (missing > 0)
        diagnostics.push_back(
            {Severity::warning, "",
             std::to_string(missing) + " surface entities of the file gave no face:" + labels});
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
    note_untranslated(reader, document.diagnostics);
    MappedItems none;
    read_assembly(source, {}, none, document);
    const auto remarks = reader_remarks(reader.WS(), document.diagnostics);
    for (CadPart& part : document.parts) part.remarks_on = remarks;
    return document;
}

} // namespace keiko::cad
