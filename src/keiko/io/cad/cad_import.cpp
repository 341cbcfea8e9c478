#include "keiko/io/cad/cad_import.h"

#include "keiko/base/error.h"
#include "keiko/io/cad/cad_files.h"
#include "keiko/io/cad/face_check.h"
#include "keiko/io/cad/part_conversion.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>

namespace keiko::cad {

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
    std::size_t total = 0, done = 0;
    for (const CadPart& part : document.parts) total += face_count(part.shape);
    SurfaceModel model;
    model.unit = document.unit;
    model.diagnostics = document.diagnostics;
    for (const CadPart& part : document.parts)
        append_part(model, part, [&] {
            constexpr double read = 0.5, converted = 0.8;
            job.report("import", read + (converted - read) * static_cast<double>(++done) /
                                            static_cast<double>(total));
        });
    for (const CadInstance& instance : document.instances)
        model.instances.push_back(
            {static_cast<std::uint32_t>(instance.part), instance.name, instance.transform});
    for (Diagnostic& note : invalid_faces(document, job))
        model.diagnostics.push_back(std::move(note));
    return model;
}

SurfaceModel import_cad_file(const std::filesystem::path& path, ModelFormat format,
                             const Job& job) {
    SurfaceModel model = convert_document(read_document(path, format), job);
    if (model.faces.empty() && model.lost_faces.empty())
        throw Error(path.string(), "", "no faces in the file");
    if (model.parts.size() == 1 && model.parts[0].name.empty())
        model.parts[0].name = path.stem().string();
    model.source = path.string();
    model.format = std::string(name_of(format));
    return model;
}

} // namespace keiko::cad
