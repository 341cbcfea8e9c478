#include "keiko/import/cad/cad_import.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/text.h"
#include "keiko/files/model/cad_text.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/import/cad/cad_document.h"
#include "keiko/import/cad/face_conversion.h"

#include <BRep_Tool.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <span>

namespace keiko::cad {

namespace {

template <class T>
std::uint32_t size32(const std::vector<T>& v) {
    return static_cast<std::uint32_t>(v.size());
}

/// Face::id of the next face of a model.
std::uint32_t next_id(const SurfaceModel& model) {
    return size32(model.faces) + size32(model.lost_faces) + 1;
}

/// Writes the faces of one part into the flat arrays of a model.
class PartWriter {
public:
    PartWriter(SurfaceModel& model, const CadPart& part)
        : model_(model), part_(part), first_edge_(size32(model.edges)) {}

    void write(std::span<FaceResult> faces) {
        const std::uint32_t first_face = size32(model_.faces);
        for (FaceResult& face : faces) write_face(face);
        model_.parts.push_back({part_.name, first_face, size32(model_.faces) - first_face});
        write_edges();
    }

private:
    void write_face(FaceResult& result) {
        Face face = described(result.shape);
        if (result.converted) {
            append_repairs(result.shape, face.id, *result.converted);
            append(std::move(face), *result.converted, numbers_in_part(result.edges));
            // Else all faces of the document would be held twice.
            result.converted.reset();
        } else {
            numbers_in_part(result.edges);
            model_.lost_faces.push_back({face.id, face.name, result.loss});
        }
    }

    /// The part's numbers of the edges of a face.
    std::vector<std::uint32_t> numbers_in_part(const EdgeTable& edges) {
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t i = 0; i < edges.count(); ++i)
            numbers.push_back(edges_.number_of(edges.edge(i)));
        return numbers;
    }

    void append_repairs(const TopoDS_Face& shape, std::uint32_t id,
                        const ConvertedFace& converted) {
        RepairLog log = converted.trim.log;
        if (converted.approximated > 0)
            log.add(RepairKind::surface_approximated, converted.approximated);
        if (part_.remarks_on)
            for (const std::string& remark : part_.remarks_on(shape)) log.add_remark(remark);
        for (Repair repair : log.repairs()) {
            repair.face = id;
            model_.repairs.push_back(std::move(repair));
        }
    }

    Face described(const TopoDS_Face& shape) const {
        Face face;
        face.id = next_id(model_);
        face.part = size32(model_.parts);
        face.reversed = shape.Orientation() == TopAbs_REVERSED;
        face.surface_kind = surface_kind(shape);
        if (part_.attributes_of) {
            FaceAttributes attributes = part_.attributes_of(shape);
            face.name = std::move(attributes.name);
            face.layer = std::move(attributes.layer);
            face.color = attributes.color;
            face.line = attributes.line;
        }
        return face;
    }

    void append(Face face, const ConvertedFace& converted,
                const std::vector<std::uint32_t>& edge_numbers) {
        face.approximated = converted.approximated;
        face.first_patch = size32(model_.patches);
        face.patch_count = size32(converted.patches);
        face.first_loop = size32(model_.trim_loops);
        face.loop_count = size32(converted.trim.loops);
        for (const SurfacePatch& patch : converted.patches) append(patch);
        for (const Chain& loop : converted.trim.loops) append(loop, edge_numbers);
        edge_uses_.resize(edges_.count());
        for (const std::uint32_t edge : converted.trim.edge_uses) ++edge_uses_[edge_numbers[edge]];
        model_.faces.push_back(std::move(face));
    }

    void append(const SurfacePatch& patch) {
        model_.patches.push_back({size32(model_.faces), size32(model_.control_points),
                                  static_cast<std::uint16_t>(patch.degree_u),
                                  static_cast<std::uint16_t>(patch.degree_v), patch.map_u,
                                  patch.map_v});
        model_.control_points.insert(model_.control_points.end(), patch.points.begin(),
                                     patch.points.end());
    }

    void append(const Chain& loop, const std::vector<std::uint32_t>& edge_numbers) {
        model_.trim_loops.push_back({size32(model_.trim_curves), size32(loop)});
        for (const LoopCurve& curve : loop) {
            const std::uint32_t edge =
                curve.edge == no_index ? no_index : first_edge_ + edge_numbers[curve.edge];
            model_.trim_curves.push_back({size32(model_.trim_points),
                                          static_cast<std::uint16_t>(curve.points.size() - 1),
                                          edge});
            model_.trim_points.insert(model_.trim_points.end(), curve.points.begin(),
                                      curve.points.end());
        }
    }

    void write_edges() {
        edge_uses_.resize(edges_.count());
        for (std::uint32_t i = 0; i < edges_.count(); ++i) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges_.edge(i));
            const double tolerance = BRep_Tool::Tolerance(edge);
            // OpenCASCADE gives an infinite one to an edge with a point beyond all numbers.
            model_.edges.push_back({std::isfinite(tolerance) ? tolerance : 0, edge_uses_[i],
                                    BRep_Tool::Degenerated(edge)});
        }
    }

    SurfaceModel& model_;
    const CadPart& part_;
    std::uint32_t first_edge_;
    EdgeTable edges_;
    std::vector<std::uint32_t> edge_uses_;
};

/// Appends a part with all its faces, numbered on from those already there, to `model`. A face
/// that could not be converted goes to the lost ones with its reason; repairs are listed. Takes
/// what was converted out of `faces`.
void append_part(SurfaceModel& model, const CadPart& part, std::span<FaceResult> faces) {
    PartWriter(model, part).write(faces);
}

/// Makes room in `model` for all that append_part will add of these faces.
void reserve(SurfaceModel& model, std::span<const FaceResult> faces) {
    std::size_t patches = 0, control_points = 0, loops = 0, curves = 0, trim_points = 0;
    for (const FaceResult& face : faces) {
        if (!face.converted) continue;
        patches += face.converted->patches.size();
        for (const SurfacePatch& patch : face.converted->patches)
            control_points += patch.points.size();
        loops += face.converted->trim.loops.size();
        for (const Chain& loop : face.converted->trim.loops) {
            curves += loop.size();
            for (const LoopCurve& curve : loop) trim_points += curve.points.size();
        }
    }
    model.faces.reserve(faces.size());
    model.patches.reserve(patches);
    model.control_points.reserve(control_points);
    model.trim_loops.reserve(loops);
    model.trim_curves.reserve(curves);
    model.trim_points.reserve(trim_points);
}

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

/// "no faces in the file", and why: what the reader passed over, by the first of it.
std::string no_faces(const CadDocument& document) {
    std::string text = "no faces in the file";
    if (const std::string missing = without_files(document); !missing.empty())
        text += "; " + missing;
    else if (const std::size_t count = document.lost_faces.size(); count > 0)
        text += ": " + document.lost_faces.front().reason +
                (count > 1 ? "; and " + std::to_string(count - 1) + " more" : "");
    return text;
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
    for (const UnreadFace& face : document.lost_faces)
        model.lost_faces.push_back({next_id(model), face.name, face.reason});
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
    if (model.faces.empty() && model.lost_faces.size() == document.lost_faces.size())
        throw Error(path.string(), "", no_faces(document));
    if (model.parts.size() == 1 && model.parts[0].name.empty())
        model.parts[0].name = path.stem().string();
    model.source = path.string();
    model.format = std::string(name_of(format));
    return model;
}

} // namespace keiko::cad
