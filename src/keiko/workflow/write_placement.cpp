#include "keiko/workflow/write_placement.h"

#include "keiko/base/error.h"
#include "keiko/base/output_file.h"
#include "keiko/film/image_file.h"
#include "keiko/report/json/placement_json.h"
#include "keiko/workflow/placement_pictures.h"
#include "keiko/workflow/version.h"

namespace keiko {

void write_placement(const std::filesystem::path& folder, const Scene& scene,
                     const PlaceResult& result, const Job& job) {
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code) throw Error(folder.string(), "", "cannot make the folder: " + code.message());
    std::vector<std::string> views;
    for (const NamedView& view : result.views) views.push_back(view.name);
    write_text_file(folder / "placement.json",
                    placement_json(result.placement, scene.model, views, version()));
    for (std::size_t i = 0; i < result.placement.planes.size(); ++i)
        write_png(folder / ("histogram-" + std::to_string(i + 1) + ".png"),
                  histogram_picture(result.placement.planes[i]));
    write_png(folder / "plan.png", plan_picture(scene, result, job));
}

} // namespace keiko
