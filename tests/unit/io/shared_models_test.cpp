#include "keiko/base/error.h"
#include "keiko/io/cad/cad_import.h"
#include "keiko/io/load_model.h"
#include "keiko/io/model_format.h"
#include "keiko/patch/trim_region.h"

#include "tests/support/paths.h"
#include <BRepTopAdaptor_FClass2d.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <random>
#include <sstream>

namespace keiko::cad {
namespace {

struct ManifestRow {
    std::string file;
    int faces = -1; ///< -1: OpenCASCADE does not survive the file
};

/// The STEP, IGES and BREP files of the collection.
std::vector<ManifestRow> manifest() {
    std::ifstream in(test::shared_model("MANIFEST.tsv"));
    std::vector<ManifestRow> rows;
    for (std::string line; std::getline(in, line);) {
        std::vector<std::string> columns;
        std::istringstream words(line);
        for (std::string word; std::getline(words, word, '\t');) columns.push_back(word);
        const std::string extension = std::filesystem::path(columns.at(1)).extension();
        if (extension != ".step" && extension != ".igs" && extension != ".brep") continue;
        rows.push_back({columns[1], columns[3] == "-" ? -1 : std::stoi(columns[3])});
    }
    return rows;
}

std::size_t placed_faces(const SurfaceModel& model) {
    std::size_t count = model.lost_faces.size();
    for (const Instance& instance : model.instances) count += model.parts[instance.part].face_count;
    return count;
}

TEST(SharedModels, EachLoadsWithoutSilentLossOrFailsInOneLine) {
    KEIKO_NEEDS_SHARED_MODEL("MANIFEST.tsv");
    for (const ManifestRow& row : manifest()) {
        const auto start = std::chrono::steady_clock::now();
        std::string result;
        try {
            const SurfaceModel model = load_model(test::shared_model(row.file));
            EXPECT_EQ(static_cast<int>(placed_faces(model)), row.faces) << row.file;
            EXPECT_EQ(model.lost_faces.empty() || row.file.starts_with("bad-"), true) << row.file;
            result = std::to_string(model.faces.size()) + " faces, " +
                     std::to_string(model.lost_faces.size()) + " lost, " +
                     std::to_string(model.patches.size()) + " patches, " +
                     std::to_string(model.diagnostics.size()) + " remarks";
        } catch (const Error& e) {
            EXPECT_LE(row.faces, 0) << e.what();
            result = e.reason();
        }
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        std::printf("%-50s %6.2f s  %s\n", row.file.c_str(), seconds.count(), result.c_str());
    }
}

/// Whether the face has a patch at a place of its parameters.
bool covered(const SurfaceModel& model, const Face& face, const Vec2& at) {
    for (const Patch& p : model.patches_of(face))
        if (p.map_u.begin <= at.x && at.x <= p.map_u.end && p.map_v.begin <= at.y &&
            at.y <= p.map_v.end)
            return true;
    return false;
}

/// Number of random places where our trim region and OpenCASCADE's classifier disagree.
int disagreements(const SurfaceModel& model, const Face& face, const TopoDS_Face& shape) {
    const TrimRegion material(model, face);
    if (material.untrimmed()) return 0;
    BRepTopAdaptor_FClass2d classifier(TopoDS::Face(shape.Oriented(TopAbs_FORWARD)), 1e-9);
    const Box2 box = material.bounds();
    const Vec2 extent = box.extent();
    std::mt19937_64 random(face.id);
    std::uniform_real_distribution<double> unit(0, 1);
    int different = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec2 at(box.lower.x + extent.x * unit(random), box.lower.y + extent.y * unit(random));
        if (!covered(model, face, at)) continue;
        // The classifier works on polygons: it may be wrong by their sagitta.
        if (material.nearest_curve(at, ParameterMetric(Vec2(1) / extent), 5e-3)) continue;
        const TopAbs_State state = classifier.Perform(gp_Pnt2d(at.x, at.y), false);
        if (state == TopAbs_IN || state == TopAbs_OUT)
            different += (state == TopAbs_IN) != material.contains(at);
    }
    return different;
}

TEST(SharedModels, TrimsAgreeWithOpenCascadesClassifier) {
    KEIKO_NEEDS_SHARED_MODEL("MANIFEST.tsv");
    for (const ManifestRow& row : manifest()) {
        if (row.file.starts_with("bad-") || row.file.starts_with("signal-light")) continue;
        const auto path = test::shared_model(row.file);
        const CadDocument document = read_document(path, detect_model_format(path));
        const SurfaceModel model = convert_document(document);
        std::size_t next = 0;
        for (const CadPart& part : document.parts) {
            TopTools_IndexedMapOfShape shapes;
            TopExp::MapShapes(part.shape, TopAbs_FACE, shapes);
            for (int i = 1; i <= shapes.Extent(); ++i) {
                const Face& face = model.faces.at(next++);
                EXPECT_EQ(disagreements(model, face, TopoDS::Face(shapes(i))), 0)
                    << row.file << " " << model.describe(face);
            }
        }
    }
}

} // namespace
} // namespace keiko::cad
