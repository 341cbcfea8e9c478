#include "keiko/viewer/client_watch.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace keiko::viewer {

ClientWatch::ClientWatch(const Outlet& outlet, LatestWork::Turn& turn)
    : watcher_([&outlet, &turn](const std::stop_token& over) {
          constexpr std::chrono::milliseconds between_looks{20};
          std::mutex mutex;
          std::condition_variable_any woken;
          std::unique_lock lock(mutex);
          while (!over.stop_requested()) {
              if (!outlet.is_open()) return turn.end();
              woken.wait_for(lock, over, between_looks, [] { return false; });
          }
      }) {}

} // namespace keiko::viewer
