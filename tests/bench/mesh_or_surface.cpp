#include "tests/bench/mesh_or_surface.h"

#include "keiko/film/image_file.h"
#include "keiko/film/overlay.h"

#include "tests/bench/brep_mesh.h"
#include "tests/bench/keiko_contender.h"
#include "tests/bench/mesh_contender.h"
#include "tests/bench/scenes.h"
#include "tests/bench/zebra_view.h"
#include "tests/integration/opencascade_tracer.h"
#include <TopoDS_Shape.hxx>

#include <algorithm>

namespace keiko::bench {
namespace {

constexpr int side = 440, gap = 8, band = 30; // px: a crop, between crops, for a label

/// On the edge of the hood's power dome.
Camera close_up() {
    Camera camera;
    camera.eye = Vec3(-900, -900, 1500);
    camera.target = Vec3(495, -290, 740);
    camera.vertical_fov = 4;
    camera.width = camera.height = side;
    return camera;
}

CPlane lamps() {
    CPlane plane;
    plane.origin = Vec3(-2000, -3000, 3000);
    plane.u = Vec3(8000, 0, 0);
    plane.v = Vec3(0, 6000, 0);
    plane.lamps = 80;
    plane.diameter = 37.5;
    return plane;
}

void place(Image& sheet, const Image& crop, int column) {
    for (int y = 0; y < crop.height; ++y)
        for (int x = 0; x < crop.width; ++x)
            std::copy_n(crop.pixel(x, y), 3,
                        sheet.pixel(gap + column * (side + gap) + x, band + y));
}

} // namespace

void draw_mesh_or_surface(const std::filesystem::path& output) {
    require_image_extension(output);
    const SceneFile scene = chosen_scenes({"hood"}).front();
    const SurfaceModel model = scene.load();
    const KeikoContender keiko(model);
    const Box3& bounds = keiko.tracer().bounds();
    const TopoDS_Shape shape = test::read_shape(scene.file);

    Image sheet(3 * side + 4 * gap, side + band + gap, 3, 1.0F);
    Overlay labels;
    int column = 0;
    const auto show = [&](const Contender& contender, const std::string& label) {
        place(sheet, zebra_view(contender, close_up(), lamps()), column);
        labels.texts.push_back(
            {.at = Vec2(gap + column * (side + gap), 9), .text = label, .color = Rgb(0.1)});
        ++column;
    };
    for (const double deflection : {0.1, 0.01}) {
        const MeshContender mesh(brep_mesh(shape, deflection, bounds.center()), bounds,
                                 {.kind = Kind::mesh, .name = "mesh", .deflection = deflection});
        show(mesh, (deflection == 0.1 ? "mesh, 0.1 mm" : "mesh, 0.01 mm"));
    }
    show(keiko, "Keiko, the surface itself");
    write_png(output, with_overlay(std::move(sheet), labels));
}

} // namespace keiko::bench
