#pragma once

#include "keiko/viewer/http_message.h"
#include "keiko/viewer/latest_work.h"

#include <thread>

namespace keiko::viewer {

/// Ends work once its client has gone, for as long as this object lives. Nothing is written to the
/// client meanwhile.
class ClientWatch {
public:
    /// Keeps references to both.
    ClientWatch(const Outlet& outlet, LatestWork::Turn& turn);

private:
    std::jthread watcher_;
};

} // namespace keiko::viewer
