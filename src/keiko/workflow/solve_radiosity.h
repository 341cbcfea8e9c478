#pragma once

#include "keiko/base/error.h"
#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/radiosity/radiosity_solution.h"
#include "keiko/workflow/open_scene.h"

#include <filesystem>
#include <string>

namespace KEIKO_API keiko {

/// Light that the diffuse surfaces of a scene reflect onto each other under its rig
/// (docs/theory/radiosity.md), divided as `scene.radiosity` says. Glass is left out,
/// and so are maps of reflectances, the environment and volumes. Its `deviation` must be below half
/// of the thinnest sheet, or else elements of both skins may cross. The scene must have been opened
/// with shadows. A stop of the job while light is shot ends it early, with a solution whose
/// `remaining` says so. Throws Error for a scene without lamps and for one with a material that
/// reflects all light, FieldError for one that needs too many elements, and Cancelled for a stop
/// before light is shot.
RadiositySolution solve_radiosity(const Scene& scene, const Job& job = {});

/// Warnings of what a scene has that solve_radiosity() leaves out: maps of reflectances, an
/// environment that lights, volumes.
Diagnostics radiosity_remarks(const Scene& scene);

/// Writes a solution (keiko-solution/1) as a whole or not at all. Throws Error, also for one whose
/// `remaining` is not finite.
void write_solution(const std::filesystem::path& path, const RadiositySolution& solution);

/// Gives a scene the reflected light of a solution. Throws Error for a file that is no solution,
/// and for one of other geometry, other reflectances, or lamps that differ in more than levels.
void take_solution(Scene& scene, const std::filesystem::path& path);

} // namespace keiko
