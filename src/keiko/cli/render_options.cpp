#include "keiko/cli/render_options.h"

#include "keiko/cli/session.h"

namespace keiko::cli {

void RenderArguments::add_to(CLI::App& command) {
    scene.add_to(command, "MODEL|SCENE");
    scene.add_picture_size(command);
    scene.add_shadows(command);
    scene.add_analysis(command);
    CLI::Option* solution = scene.add_solution(command);
    command.add_option("-o,--output", output, "image.exr (cd/m2, AOVs) or image.png")->required();
    add_light(command);
    of_lamps_.push_back(solution->excludes("--rig")->needs("--shadows"));
    of_lamps_.push_back(
        command
            .add_option(
                "--gather", gather_rays,
                "rays that gather the light of surfaces at each pixel, slower, and off by 2 % "
                "RMS at 256, 0.8 % at 1024; 0: it is interpolated between corners of elements")
            ->check(CLI::Range(0, 65536))
            ->needs(solution)
            ->capture_default_str());
    command
        .add_option("--aov", aovs_,
                    "layers of an .exr, comma-separated: luminance, normal, uv, face, patch, "
                    "depth, c_plane_uv, illuminance, curvature")
        ->check(not_empty());
    add_false_colors(command);
    add_display(command);
    add_looks(command);
    add_stereo(command);
    add_frames(command);
}

void RenderArguments::add_light(CLI::App& command) {
    of_lamps_.push_back(command.get_option("--shadows"));
    of_lamps_.push_back(
        command
            .add_option(
                "--penumbrae", penumbrae_,
                "of tubes: width, weighed over all of each, but for thin bars and slits along it, "
                "which it may miss; exact, as keiko illuminance has it with --light-error 0, up to "
                "six times slower; or axis, cut along the axis alone, sooner and off by up to some "
                "percent")
            ->check(CLI::IsMember({"axis", "width", "exact"}))
            ->needs("--shadows")
            ->capture_default_str());
    of_lamps_.push_back(
        command
            .add_option(
                "--light-error", light_error,
                "share of what is seen by which the lamps' light on bases may be off for being "
                "found a few pixels apart; shadows narrower than two pixels may have holes, and "
                "up to eight on curved surfaces and in penumbrae of others, as narrow light amid "
                "shadows may anywhere, however small it is; the light of an open sky may be off "
                "by three times as much of what it is past no body, and by 0.0025 more; "
                "0: found in each pixel, slower")
            ->check(number_between(0, 0.1))
            ->capture_default_str());
    of_lamps_.push_back(
        command
            .add_option("--edge-samples", edge_samples,
                        "into how many parts a side a pixel is cut at the most where outlines meet "
                        "in it, halved until so small; 1: one ray a pixel, sooner, with outlines "
                        "in stairs")
            ->check(CLI::Range(1, 16))
            ->capture_default_str());
    of_surface_ = of_lamps_;
    command.add_option("--view", view, "view by name, auto, or scene")->check(not_empty());
    rig_ = command.add_option("--rig", rig, "rig file, or auto: the scene's, or placed")
               ->check(not_empty())
               ->capture_default_str();
}

void RenderArguments::add_false_colors(CLI::App& command) {
    auto* flag = command.add_flag("--false-color", false_color,
                                  "luminance by colour from blue to red, with a legend, for .png");
    command
        .add_option("--quantity", quantity_,
                    "of the false colours: luminance in cd/m2, or illuminance in lx, direct light "
                    "alone as keiko illuminance tells it")
        ->check(CLI::IsMember({"luminance", "illuminance"}))
        ->needs(flag)
        ->capture_default_str();
    command
        .add_option("--scale", scale_,
                    "of false colours MIN:MAX, cd/m2 or lx [1:10000]; of a --look with a legend "
                    "MIN:MAX in its unit, or P%, what that share of the body's picture does not "
                    "exceed, rounded up [98%]")
        ->check(not_empty());
    command
        .add_flag("--iso-lines", iso_lines,
                  "lines of equal value at the values of the legend, with their numbers")
        ->needs(flag);
}

void RenderArguments::add_display(CLI::App& command) {
    auto* false_colors = command.get_option("--false-color");
    of_lamps_.push_back(
        command
            .add_option(
                "--tone", tone_,
                "curve of a .png: linear, to judge stripes by; log and reinhard, to see dark and "
                "bright at once")
            ->check(CLI::IsMember({"linear", "log", "reinhard"}))
            ->excludes(false_colors)
            ->capture_default_str());
    of_lamps_.push_back(
        command.add_option("--ev", ev_, "exposure value of a .png [99 % of the body below white]")
            ->check(number_between(-100, 100))
            ->excludes(false_colors));
}

void RenderArguments::add_looks(CLI::App& command) {
    stated_look_ =
        command
            .add_option(
                "--look", look_,
                "what to look at, for .png: lamps, zebra, isophote, highlight (of the rig), "
                "isoparms, patches; or by colour with a legend draft, curvature:gauss, :mean, "
                ":k1, :k2, :absolute, :section, or radius; curvature:gauss=C: colours are full "
                "at C; below-radius, in red; or distortion: how glass turns the line of sight. Or, "
                "under the lamps, what a mesh shows of the surface: mesh:constant, mesh:gouraud or "
                "mesh:phong")
            ->option_text("NAME")
            ->excludes(command.get_option("--false-color"))
            ->capture_default_str();
    command
        .add_option("--pull", pull_, "of --look draft: X,Y,Z, where the tool is pulled off [0,0,1]")
        ->check(not_empty());
    command
        .add_option("--draft", draft_,
                    "of --look draft: degrees below which draft is too small [3]")
        ->check(number_between(0, 90));
    command
        .add_option("--section", section_,
                    "of --look curvature:section: X,Y,Z, normal of the parallel planes [0,1,0]")
        ->check(not_empty());
    command
        .add_option(
            "--mesh", mesh_,
            "of --look mesh:...: mm by which the surface may leave the triangles; or pixel: "
            "the exact patches, divided until each pixel has a facet of its own [0.1]")
        ->option_text("MM|pixel")
        ->check(CLI::IsMember({"pixel"}) | number_between(1e-6, 1e6));
    stated_hidden_ =
        command
            .add_option("--hidden-surfaces", hidden_surfaces_,
                        "of --look mesh:...: algorithm that finds what is seen, z-buffer, "
                        "scan-line or painter; the same but where depths agree to rounding")
            ->check(CLI::IsMember({"z-buffer", "scan-line", "painter"}))
            ->option_text("NAME")
            ->capture_default_str();
    stated_mesh_shadows_ =
        command
            .add_option("--mesh-shadows", mesh_shadows_,
                        "of --look mesh:...: algorithm that finds the shadows of the mesh, ray, "
                        "scan-line, map, polygons or volumes; the same but at edges. Of points, "
                        "the sun, panels and spheres")
            ->check(CLI::IsMember({"none", "ray", "scan-line", "map", "polygons", "volumes"}))
            ->option_text("NAME")
            ->capture_default_str();
    command.add_option("--radius", radius_, "of --look below-radius: mm, which needs it")
        ->check(number_between(1e-6, 1e6));
}

void RenderArguments::add_stereo(CLI::App& command) {
    CLI::Option* stereo =
        command
            .add_option("--stereo", stereo_,
                        "for two eyes: side-by-side, the left eye's picture on the left, each of "
                        "the picture's size; or anaglyph, for glasses that are red on the left "
                        "and cyan on the right")
            ->check(CLI::IsMember({"side-by-side", "anaglyph"}))
            ->excludes(command.get_option("--false-color"));
    of_lamps_.push_back(stereo);
    of_surface_.push_back(stereo);
    command
        .add_option("--eye-distance", eye_distance_,
                    "mm between the eyes, the camera being in their middle")
        ->check(number_between(1e-3, 1e6))
        ->needs(stereo)
        ->capture_default_str();
    command
        .add_option("--screen-distance", screen_distance_,
                    "mm from the eyes to the screen; what is nearer stands out of it [the "
                    "camera's target]")
        ->check(number_between(1e-3, 1e9))
        ->needs(stereo);
}

void RenderArguments::add_frames(CLI::App& command) {
    auto* frames = command
                       .add_option("--frames", frames_,
                                   "A:B, of a scene with [[animation]]: a picture of each, "
                                   "image-0000.png and on")
                       ->check(not_empty());
    command
        .add_option("--register", hits,
                    "file (.json) for what the picture mirrors, for keiko place --from")
        ->excludes(frames);
    command
        .add_flag("--resume", resume,
                  "leave out frames whose picture is there, made of the same files and options")
        ->needs(frames);
}

} // namespace keiko::cli
