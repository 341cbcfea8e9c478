#include "keiko/viewer/endpoints.h"

#include "keiko/api/model.h"
#include "keiko/api/render.h"
#include "keiko/api/scene.h"
#include "keiko/base/error.h"
#include "keiko/base/log.h"
#include "keiko/viewer/client_watch.h"
#include "keiko/viewer/page_request.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <thread>

namespace keiko::viewer {
namespace {

constexpr std::string_view no_such = "there is nothing of that name";

HttpReply text_reply(std::string text) {
    return {.body = std::move(text)};
}

HttpReply toml_reply(std::string text) {
    return {.type = "application/toml", .body = std::move(text)};
}

std::string event_of(const WorkProgress& progress) {
    std::string fraction = std::to_string(std::clamp(progress.fraction, 0.0, 1.0));
    return "data: {\"work\":\"" + progress.kind + "\",\"stage\":\"" + progress.stage +
           "\",\"fraction\":" + fraction + "}\n\n";
}

/// Sends the progress of a client's work until that or the server ends.
bool send_events(LatestWork& work, const std::string& client, Outlet& outlet,
                 const std::stop_token& stop) {
    constexpr std::chrono::milliseconds between{50};
    std::uint64_t last = 0;
    while (!stop.stop_requested() && outlet.is_open()) {
        const auto progress = work.next_progress(client, last, stop);
        // A comment shows the client that the server is there.
        if (!outlet.write(progress ? event_of(*progress) : ": \n\n")) return false;
        if (!progress) continue;
        last = progress->number;
        std::this_thread::sleep_for(between);
    }
    return true;
}

} // namespace

HttpReply Endpoints::answer(const HttpRequest& request) const {
    try {
        return routed(request, client_of(request));
    } catch (const Cancelled&) {
        return error_reply(409, "a newer request, or the end of the server, ended this one");
    } catch (const Error& error) {
        return error_reply(400, error.what());
    } catch (const std::bad_alloc&) {
        return error_reply(500, "out of memory");
    }
}

HttpReply Endpoints::routed(const HttpRequest& request, const std::string& client) const {
    const std::string asked = request.method + " " + request.path;
    if (asked == "GET /scene") return scene_facts();
    if (asked == "GET /rig") return rig_file();
    if (asked == "PUT /rig") return new_rig(request);
    if (asked == "POST /rig") return changed_rig_file(request);
    if (asked == "GET /analysis") return text_reply(scene_.analysis());
    if (asked == "POST /deep") return deep(request, client);
    if (asked == "POST /still") return still(request, client);
    if (asked == "POST /pick") return pick(request);
    if (asked == "POST /lines") return lines(request, client);
    if (scene_.against() && request.path.starts_with("/against/")) return against(request, client);
    if (asked == "GET /events") return events(client);
    LatestWork::Turn turn(work_, client,
                          request.path.substr(std::min<std::size_t>(1, request.path.size())));
    const Job job = turn.job(threads_);
    const StopScope scope(job);
    if (asked == "GET /facts") return text_reply(scene_.facts(job));
    if (asked == "GET /seams") return text_reply(scene_.inspection(job));
    if (asked == "GET /inspect") return text_reply(scene_.faults(job));
    if (asked == "POST /inspect")
        return text_reply(scene_.faults_with_lines(request_of(request), job));
    if (asked == "PUT /analysis") return new_analysis(request, job);
    if (asked == "POST /analysis") return analysis_file(request, job);
    if (asked == "POST /profile") return text_reply(scene_.profile(request.body, job));
    if (asked == "POST /section") return text_reply(scene_.section(request.body, job));
    if (asked == "POST /place") return place(request, job);
    return error_reply(404, no_such);
}

HttpReply Endpoints::scene_facts() const {
    return text_reply(view_json(scene_.facts_of_view(), scene_.rig()));
}

HttpReply Endpoints::against(const HttpRequest& request, const std::string& client) const {
    const Scene& earlier = *scene_.against();
    const std::string asked = request.method + " " + request.path;
    if (asked == "GET /against/scene")
        return text_reply(view_json(view_facts(earlier, scene_.view()), scene_.rig()));
    if (asked == "POST /against/deep") return deep(request, client, &earlier);
    if (asked == "POST /against/still") return still(request, client, &earlier);
    return error_reply(404, no_such);
}

HttpReply Endpoints::rig_file() const {
    return toml_reply(rig_text(scene_.rig()));
}

HttpReply Endpoints::new_rig(const HttpRequest& request) const {
    scene_.set_rig(parse_rig_alone(request.body, "rig"));
    return text_reply(rig_json(scene_.rig()));
}

HttpReply Endpoints::changed_rig_file(const HttpRequest& request) const {
    return toml_reply(rig_text(scene_.rig_of(request_of(request))));
}

HttpReply Endpoints::pick(const HttpRequest& request) const {
    const ViewRequest wanted = request_of(request);
    if (!wanted.pixel) throw Error("request", "pixel", "is missing");
    const Scene& scene = scene_.scene();
    return text_reply(pick_json(pick_place(scene, seen_without(scene, wanted.hidden),
                                           scene_.view_of(wanted).camera, *wanted.pixel)));
}

HttpReply Endpoints::place(const HttpRequest& request, const Job& job) const {
    const Scene& scene = scene_.scene();
    PlaceOptions options;
    options.hits =
        register_hits(scene.tracer, scene.model, {scene_.view_of(request_of(request))}, job);
    return text_reply(placed_rig_json(place_scene(scene, options, job).placement));
}

HttpReply Endpoints::new_analysis(const HttpRequest& request, const Job& job) const {
    const FollowedAnalysis followed = followed_analysis(
        parse_analysis_alone(request.body, "analysis"), scene_.scene().model, job);
    if (followed.analysis.rig) scene_.set_rig(*followed.analysis.rig);
    return text_reply(view_analysis_json(followed, scene_.rig()));
}

HttpReply Endpoints::analysis_file(const HttpRequest& request, const Job& job) const {
    return text_reply(analysis_text(
        requested_analysis(request_of(request), scene_.rig(), scene_.scene().model, job)));
}

HttpReply Endpoints::streamed(const std::string& type, const std::string& client,
                              const std::string& kind, Streamed work) const {
    HttpReply reply{.type = type};
    reply.stream = [this, client, kind, work = std::move(work)](Outlet& outlet) {
        LatestWork::Turn turn(work_, client, kind);
        try {
            return work(outlet, turn);
        } catch (const Cancelled&) {
        } catch (const std::exception& error) {
            log_error(kind + ": " + error.what());
        }
        return false;
    };
    return reply;
}

HttpReply Endpoints::made(const std::string& type, const std::string& client,
                          const std::string& kind,
                          std::function<std::string(const Job&)> make) const {
    return streamed(type, client, kind,
                    [this, make = std::move(make)](Outlet& outlet, LatestWork::Turn& turn) {
                        std::string bytes;
                        {
                            const ClientWatch watch(outlet, turn);
                            const Job job = turn.job(threads_);
                            const StopScope scope(job);
                            bytes = make(job);
                        }
                        return outlet.write(bytes);
                    });
}

bool Endpoints::send_deep(const ViewRequest& request, const Scene* earlier, Outlet& outlet,
                          LatestWork::Turn& turn) const {
    std::vector<RowSet> passes{RowSet{}};
    const auto interlaced = interlaced_rows();
    if (request.interlaced) passes.assign(interlaced.begin(), interlaced.end());
    for (const RowSet& rows : passes) {
        std::string bytes;
        {
            const ClientWatch watch(outlet, turn);
            const Job job = turn.job(threads_);
            const DeepOptions options{.rows = rows, .reflections = request.reflections};
            bytes = deep_bytes(
                earlier ? deep_view(*earlier, scene_.view_of(request).camera, options, job)
                        : scene_.deep(request, options, job));
        }
        if (!outlet.write(bytes)) return false;
    }
    return true;
}

HttpReply Endpoints::deep(const HttpRequest& request, const std::string& client,
                          const Scene* earlier) const {
    const ViewRequest wanted = request_of(request);
    require_faces(scene_.scene().model, wanted.hidden);
    return streamed("application/octet-stream", client, earlier ? "deep before" : "deep",
                    [this, wanted, earlier](Outlet& outlet, LatestWork::Turn& turn) {
                        return send_deep(wanted, earlier, outlet, turn);
                    });
}

std::string Endpoints::still_png(const ViewRequest& request, const LightRig& rig,
                                 const Scene* earlier, const Job& job) const {
    const Film film = earlier ? render_view(*earlier, rig, scene_.view_of(request).camera, {}, job)
                              : scene_.still(request, rig, job);
    return encode_png(tone_mapped(film, {.ev = request.ev}));
}

HttpReply Endpoints::still(const HttpRequest& request, const std::string& client,
                           const Scene* earlier) const {
    const ViewRequest wanted = request_of(request);
    require_faces(scene_.scene().model, wanted.hidden);
    const LightRig rig = scene_.rig_of(wanted);
    scene_.reflected(rig, {}); // refuses lamps while there still is an answer to put it into
    return made("image/png", client, earlier ? "still before" : "still",
                [this, wanted, earlier, rig](const Job& job) {
                    return still_png(wanted, rig, earlier, job);
                });
}

HttpReply Endpoints::lines(const HttpRequest& request, const std::string& client) const {
    const ViewRequest wanted = request_of(request);
    if (!has_lines(scene_.rig_of(wanted)))
        throw Error("request", "lamps",
                    "there is neither a row of lamps nor a panel, so that there are no lines");
    return made("application/json", client, "lines", [this, wanted](const Job& job) {
        return lines_json(scene_.lines(wanted, job), scene_.scene().model);
    });
}

HttpReply Endpoints::events(const std::string& client) const {
    return streamed("text/event-stream", client, "events",
                    [this, client](Outlet& outlet, LatestWork::Turn& turn) {
                        return send_events(work_, client, outlet, turn.stop());
                    });
}

} // namespace keiko::viewer
