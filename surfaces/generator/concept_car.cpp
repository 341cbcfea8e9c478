#include "car_body.h"
#include "car_greenhouse.h"
#include "car_trims.h"
#include "car_truths.h"
#include "car_wheel.h"
#include "fixtures.h"
#include "trimmed_skin.h"

namespace keiko::fixtures {
namespace {

void append(std::vector<NamedFace>& all, std::vector<NamedFace> more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// The faces inside a closed curve on side 0, in which no cell is whole.
std::vector<NamedFace> panel(TrimmedSkin& trimmed, const std::string& name,
                             const TrimCurve& curve) {
    return trimmed.faces({name, {{&curve, 0}}, [](Cell) { return false; }});
}

std::vector<NamedFace> body_faces(const Skin& skin, const CarTrims& trims, ShapePool& pool) {
    Region body{"body", {{&trims.greenhouse_foot, 0}}, [&](Cell cell) {
                    return !is_in_wheel_arch(skin, cell);
                }};
    for (const TrimCurve& arch : trims.wheel_arches) body.boundaries.push_back({&arch, 0});
    for (const auto& [name, curve] : trims.body_panels)
        body.boundaries.push_back({&curve, 0, true});
    TrimmedSkin trimmed(skin, body.boundaries, false, pool);
    std::vector<NamedFace> faces = trimmed.faces(body);
    for (const auto& [name, curve] : trims.body_panels) append(faces, panel(trimmed, name, curve));
    return faces;
}

std::vector<NamedFace> greenhouse_faces(const Skin& skin, const CarTrims& trims, ShapePool& pool) {
    const auto above_the_body = [&](Cell cell) {
        return encloses(trims.greenhouse_foot, 1, {cell.column + 0.5, cell.row + 0.5});
    };
    Region roof{"roof", {{&trims.greenhouse_foot, 1}}, above_the_body};
    for (const auto& [name, curve] : trims.windows) roof.boundaries.push_back({&curve, 0, true});
    TrimmedSkin trimmed(skin, roof.boundaries, true, pool);
    std::vector<NamedFace> faces = trimmed.faces(roof);
    for (const auto& [name, curve] : trims.windows) append(faces, panel(trimmed, name, curve));
    return faces;
}

} // namespace

Fixture concept_car() {
    const Skin body = car_body();
    const Skin greenhouse = car_greenhouse();
    const CarTrims trims = car_trims(body, greenhouse);
    ShapePool pool;
    std::vector<NamedFace> faces = body_faces(body, trims, pool);
    append(faces, greenhouse_faces(greenhouse, trims, pool));
    append(faces, car_wheels(pool));
    const std::vector<GroundTruth> truths = car_truths(body, greenhouse, trims, faces);
    return {"concept-car.step", faces, truths};
}

} // namespace keiko::fixtures
