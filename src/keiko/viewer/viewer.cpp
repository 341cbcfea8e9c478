#include "keiko/viewer/viewer.h"

#include "keiko/base/error.h"
#include "keiko/viewer/access.h"
#include "keiko/viewer/endpoints.h"
#include "keiko/viewer/http_server.h"
#include "keiko/viewer/page.h"

#include <utility>

namespace keiko::viewer {

void show(ShownScenes scenes, const NamedView& view, LightRig rig, const ViewerOptions& options,
          const std::function<void(const std::string& address)>& ready, const Job& job) {
    ViewedScene viewed(std::move(scenes.scene), view, std::move(rig), options.check,
                       options.report);
    viewed.set_solution(options.solution);
    if (scenes.against) viewed.set_against(std::move(*scenes.against));
    LatestWork work;
    const Endpoints endpoints(viewed, work, job.threads);
    HttpServer server(options.port);
    const Access access{server.port(), random_token()};
    const HttpHandlers handlers{
        .refuse = [&](const HttpRequest& head) { return refusal(head, access); },
        .answer =
            [&](const HttpRequest& request) {
                const PageFile* file = request.method == "GET" ? page_file(request.path) : nullptr;
                if (file)
                    return HttpReply{.type = std::string(file->type),
                                     .body = std::string(file->text)};
                return endpoints.answer(request);
            }};
    // Connections are taken from here on, and answered once the server runs.
    ready("http://127.0.0.1:" + std::to_string(server.port()) + "/#token=" + access.token);
    server.serve(handlers, job.stop, [&] { work.end_all(); });
    throw Cancelled();
}

} // namespace keiko::viewer
