#include "keiko/workflow/face_sets.h"

#include "keiko/compare/alignment/placed_model.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/workflow/visible_shares.h"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <set>

namespace keiko {
namespace {

using Words = std::vector<std::string>;

bool is_like(const std::string& text, const std::string& pattern) {
    return fnmatch(pattern.c_str(), text.c_str(), 0) == 0;
}

bool has_color(const Face& face, const FaceColor& color) {
    return face.color && FaceColor::of(*face.color) == color;
}

/// "; there are a, b" of the words, each once; what there is none of, if they are none.
std::string there_are(const std::set<std::string>& words, const char* none) {
    const Words all(words.begin(), words.end());
    return all.empty() ? "; there are " + std::string(none) : "; there are " + comma_list(all);
}

std::string known_layers(const SurfaceModel& model) {
    std::set<std::string> layers;
    for (const Face& face : model.faces)
        if (!face.layer.empty()) layers.insert(face.layer);
    return there_are(layers, "no layers");
}

std::string known_colors(const SurfaceModel& model) {
    std::set<std::string> colors;
    for (const Face& face : model.faces)
        if (face.color) colors.insert(FaceColor::of(*face.color).text());
    return there_are(colors, "no colours");
}

/// The faces of the model that `meets` holds for with any of the words. Throws FieldError for a
/// word that it holds for with none.
template <class Word, class Meets, class Reason>
std::vector<bool> any_of_words(const SurfaceModel& model, const std::vector<Word>& words,
                               const char* field, const Meets& meets, const Reason& reason) {
    std::vector<bool> found(model.faces.size(), words.empty());
    for (const Word& word : words) {
        bool used = false;
        for (std::size_t i = 0; i < found.size(); ++i)
            if (meets(model.faces[i], word)) found[i] = used = true;
        if (!used) throw FieldError(field, reason(word));
    }
    return found;
}

/// The box grown by what the box of a face may be off.
Box3 grown(Box3 box) {
    constexpr double slack = 1e-3; // mm
    box.lower -= Vec3(slack), box.upper += Vec3(slack);
    return box;
}

/// True if all material lies in a box: the control points do, or the material itself.
bool lies_in(const Box3& box, const SurfaceModel& model, const Job& job) {
    const auto holds = [&](const Box3& inner) {
        return !inner.empty() && box.contains(inner.lower) && box.contains(inner.upper);
    };
    const Box3 hull = hull_bounds(model);
    if (holds(hull)) return true;
    return hull.overlaps(box) && holds(material_bounds(model, job));
}

} // namespace

bool names_face(const std::string& pattern, const Face& face) {
    return pattern == std::to_string(face.id) || is_like(face.name, pattern);
}

FaceFinder::FaceFinder(const ZonedBody& body, const Job& job)
    : body_(body), job_(job), faces_(placed_faces(body.model)) {}

FaceSet FaceFinder::selected(const FaceSelection& selection) {
    FaceSet faces(faces_.size(), true);
    keep_named(selection, faces);
    if (selection.box) keep_in_box(*selection.box, faces);
    if (!selection.visible) return faces;
    for (std::size_t i = 0; i < faces.size(); ++i)
        faces[i] = faces[i] && shares()[i] >= *selection.visible;
    return faces;
}

FaceSet FaceFinder::outer_skin() {
    FaceSet faces;
    for (const double share : shares()) faces.push_back(share > outer_skin_share);
    return faces;
}

/// Keeps the faces by name, layer and colour.
void FaceFinder::keep_named(const FaceSelection& selection, FaceSet& faces) const {
    const SurfaceModel& model = body_.model;
    const std::array kept{
        any_of_words(
            model, selection.faces, "faces",
            [](const Face& face, const std::string& word) { return names_face(word, face); },
            [](const std::string& word) {
                return "no face has the number or a name like '" + shortened(word) + "'";
            }),
        any_of_words(
            model, selection.layers, "layers",
            [](const Face& face, const std::string& word) {
                return !face.layer.empty() && is_like(face.layer, word);
            },
            [&](const std::string& word) {
                return "no face is on a layer like '" + shortened(word) + "'" + known_layers(model);
            }),
        any_of_words(model, selection.colors, "colors", has_color, [&](const FaceColor& color) {
            return "no face has the colour " + color.text() + known_colors(model);
        })};
    for (const std::vector<bool>& by_face : kept)
        for (std::size_t i = 0; i < faces.size(); ++i)
            faces[i] = faces[i] && by_face[faces_[i].face];
}

void FaceFinder::keep_in_box(const Box3& box, FaceSet& faces) const {
    const Box3 around = grown(box);
    SurfaceModel placed = placed_model(body_.model).model; // its faces are in the same order
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
        check_stop();
        if (!faces[i]) continue;
        placed.parts.front().first_face = i, placed.parts.front().face_count = 1;
        faces[i] = lies_in(around, placed, job_);
    }
}

const std::vector<double>& FaceFinder::shares() {
    if (!shares_.empty()) return shares_;
    std::optional<Tracer> own;
    if (!body_.tracer) own.emplace(body_.model, TracerOptions{}, job_);
    shares_ = visible_shares(body_.model, own ? *own : *body_.tracer, body_.ground, job_);
    return shares_;
}

} // namespace keiko
