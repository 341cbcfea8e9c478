#include "tests/bench/scenes.h"

#include "keiko/base/error.h"
#include "keiko/import/worker/load_model.h"

#include "tests/support/paths.h"

#include <algorithm>

namespace keiko::bench {

SurfaceModel SceneFile::load() const {
    SurfaceModel model = load_model(file);
    if (scale != 1) scale_lengths(model, scale);
    return model;
}

std::vector<SceneFile> known_scenes() {
    const auto fixture = [](const char* file) { return test::repository("surfaces") / file; };
    return {
        {"concept-car", fixture("concept-car.step")},
        {"hood", fixture("hood.step")},
        // Bodies of some 6 mm, made as large as a hand: a mesh of 1 mm would be another body.
        {.name = "teapot", .file = test::shared_model("newell-teapot.bpt"), .scale = 50},
        {"car-hood", test::shared_model("car-hood.brep")},
        {"car-front-fender", test::shared_model("car-front-fender.brep")},
        {"car-rear-deck", test::shared_model("car-rear-deck-half-panel.brep")},
        {"linkrods", test::shared_model("linkrods.step"), false, 50},
        {"ship-propeller", test::shared_model("ship-propeller-and-shaft.igs"), false},
    };
}

std::vector<SceneFile> chosen_scenes(const std::vector<std::string>& names) {
    const std::vector<SceneFile> known = known_scenes();
    if (names.empty()) return known;
    std::vector<SceneFile> chosen;
    for (const std::string& name : names) {
        const auto scene = std::find_if(known.begin(), known.end(),
                                        [&](const SceneFile& s) { return s.name == name; });
        if (scene != known.end())
            chosen.push_back(*scene);
        else if (std::filesystem::exists(name))
            chosen.push_back({std::filesystem::path(name).filename().string(), name});
        else
            throw Error("", "--scene", "'" + name + "' is neither a scene nor a file");
    }
    return chosen;
}

} // namespace keiko::bench
