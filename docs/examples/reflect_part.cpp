// reflect_part MODEL PICTURE.png RIG.toml: places lamps by the reflections of a body, writes their
// rig, and draws the body under them.
#include "keiko/api/place.h"
#include "keiko/api/render.h"
#include "keiko/api/scene.h"

#include <filesystem>
#include <iostream>

int main(int argc, char** argv) try {
    if (argc != 4) {
        std::cerr << "usage: reflect_part MODEL PICTURE.png RIG.toml\n";
        return 2;
    }
    const std::filesystem::path model = argv[1], picture = argv[2], rig = argv[3];

    keiko::Job job;
    job.progress = [](const keiko::Progress& progress) {
        std::cerr << '\r' << progress.stage << ' ' << static_cast<int>(100 * progress.fraction)
                  << " %   ";
    };
    keiko::Scene scene = keiko::open_scene({&model, 1}, {}, job);
    scene.set_picture_size(480, 270);

    // Without names, the view that shows the body best.
    const keiko::PlaceResult placed = keiko::place_scene(scene, {}, job);
    const keiko::NamedView& view = placed.views.front();
    keiko::write_rig(rig, placed.placement.rig);

    const keiko::Film film = keiko::render_view(scene, placed.placement.rig, view.camera, {}, job);
    keiko::write_film(picture, film);
    std::cout << "view " << view.name << ": lamps cover " << 100 * placed.placement.coverage
              << " % of the body\n";
} catch (const keiko::Error& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
