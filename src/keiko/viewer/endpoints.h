#pragma once

#include "keiko/viewer/http_message.h"
#include "keiko/viewer/latest_work.h"
#include "keiko/viewer/viewed_scene.h"

#include <functional>
#include <string>

namespace keiko::viewer {

/// The answers to the requests of pages about one scene; docs/viewer.md lists them. May be used by
/// several threads.
class Endpoints {
public:
    /// Keeps references to both. `threads`: of each answer, as in a Job.
    Endpoints(ViewedScene& scene, LatestWork& work, int threads)
        : scene_(scene), work_(work), threads_(threads) {}

    /// The answer to a request that is allowed. Errors of the request are answers too.
    HttpReply answer(const HttpRequest& request) const;

private:
    /// Work that writes to a client, and stops once that has gone.
    using Streamed = std::function<bool(Outlet&, LatestWork::Turn&)>;

    HttpReply routed(const HttpRequest& request, const std::string& client) const;
    /// Answers that are made at once.
    HttpReply scene_facts() const;
    HttpReply rig_file() const;
    HttpReply new_rig(const HttpRequest& request) const;
    HttpReply changed_rig_file(const HttpRequest& request) const;
    /// Answers that take long; see LatestWork. `earlier`: the revision before, or null for the
    /// scene.
    HttpReply deep(const HttpRequest& request, const std::string& client,
                   const Scene* earlier = nullptr) const;
    HttpReply still(const HttpRequest& request, const std::string& client,
                    const Scene* earlier = nullptr) const;
    HttpReply pick(const HttpRequest& request) const;
    /// Answers about the revision before, which is there.
    HttpReply against(const HttpRequest& request, const std::string& client) const;
    HttpReply events(const std::string& client) const;
    HttpReply new_analysis(const HttpRequest& request, const Job& job) const;
    HttpReply analysis_file(const HttpRequest& request, const Job& job) const;
    HttpReply lines(const HttpRequest& request, const std::string& client) const;
    HttpReply place(const HttpRequest& request, const Job& job) const;

    HttpReply streamed(const std::string& type, const std::string& client, const std::string& kind,
                       Streamed work) const;
    /// Bytes that are made as a whole, and sent unless the client has gone meanwhile.
    HttpReply made(const std::string& type, const std::string& client, const std::string& kind,
                   std::function<std::string(const Job&)> make) const;
    bool send_deep(const ViewRequest& request, const Scene* earlier, Outlet& outlet,
                   LatestWork::Turn& turn) const;

    std::string still_png(const ViewRequest& request, const LightRig& rig, const Scene* earlier,
                          const Job& job) const;

    ViewedScene& scene_;
    LatestWork& work_;
    int threads_;
};

} // namespace keiko::viewer
