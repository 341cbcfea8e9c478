#include "keiko/import/cad/cad_import.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/text.h"
#include "keiko/files/model/cad_text.h"
#include "keiko/import/cad/cad_document.h"
#include "keiko/import/cad/face_faults.h"
#include "keiko/import/cad/part_conversion.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>

#include <algorithm>

namespace keiko::cad {

namespace {

/// "parts are in files that cannot be read: ..."; empty without any.
std::string without_files(const CadDocument& document) {
    if (document.missing_files.empty()) return "";
    constexpr std::size_t most_told = 8;
    std::string text = "parts are in files that cannot be read:";
    for (std::size_t i = 0; i < std::min(document.missing_files.size(), most_told); ++i)
        text += (i > 0 ? ", " : " ") + in_quotes(document.missing_files[i]);
    const std::size_t more =
        document.missing_files.size() - std::min(document.missing_files.size(), most_told);
    return text + (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

} // namespace

CadDocument read_document(const std::filesystem::path& path, ModelFormat format) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    try {
        switch (format) {
            case ModelFormat::step:
                return read_step_file(path);
            case ModelFormat::iges:
                return read_iges_file(path);
            case ModelFormat::brep:
                return read_brep_file(path);
            default:
                throw Error(path.string(), "", "not a CAD file");
        }
    } catch (const Error&) {
        throw;
    } catch (...) {
        throw Error(path.string(), "", "cannot be read: " + current_failure());
    }
}

SurfaceModel convert_document(const CadDocument& document, const Job& job) {
    constexpr double read = 0.5, converted = 0.8; // shares of the whole import
    std::vector<FaceResult> faces = convert_faces(document, job, read, converted);
    SurfaceModel model;
    model.unit = document.unit;
    model.diagnostics = document.diagnostics;
    if (std::string missing = without_files(document); !missing.empty())
        model.diagnostics.push_back({Severity::warning, "", std::move(missing)});
    reserve(model, faces);
    auto begin = faces.begin();
    for (std::size_t part = 0; part < document.parts.size(); ++part) {
        const auto end = std::find_if(begin, faces.end(),
                                      [&](const FaceResult& face) { return face.part != part; });
        append_part(model, document.parts[part], {begin, end});
        begin = end;
    }
    for (const CadInstance& instance : document.instances)
        model.instances.push_back(
            {static_cast<std::uint32_t>(instance.part), instance.name, instance.transform});
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (!faces[i].fault.empty())
            model.diagnostics.push_back(
                {Severity::note, "face " + std::to_string(i + 1), faces[i].fault});
    return model;
}

SurfaceModel import_cad_file(const std::filesystem::path& path, ModelFormat format,
                             const Job& job) {
    require_numbers(read_file(path), format, path.string());
    const CadDocument document = read_document(path, format);
    SurfaceModel model = convert_document(document, job);
    if (model.faces.empty() && model.lost_faces.empty()) {
        const std::string missing = without_files(document);
        throw Error(path.string(), "",
                    "no faces in the file" + (missing.empty() ? "" : "; " + missing));
    }
    if (model.parts.size() == 1 && model.parts[0].name.empty())
        model.parts[0].name = path.stem().string();
    model.source = path.string();
    model.format = std::string(name_of(format));
    return model;
}

} // namespace keiko::cad
