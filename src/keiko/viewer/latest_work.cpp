#include "keiko/viewer/latest_work.h"

#include <chrono>

namespace keiko::viewer {

LatestWork::Turn::Turn(LatestWork& all, std::string client, std::string kind)
    : all_(all), who_(std::move(client), std::move(kind)) {
    const std::scoped_lock lock(all_.mutex_);
    if (all_.ended_) stop_.request_stop();
    const auto before = all_.running_.find(who_);
    if (before != all_.running_.end()) before->second.request_stop();
    all_.running_.insert_or_assign(who_, stop_);
}

LatestWork::Turn::~Turn() {
    const std::scoped_lock lock(all_.mutex_);
    const auto own = all_.running_.find(who_);
    // A newer turn may stand there.
    if (own == all_.running_.end() || !(own->second == stop_)) return;
    all_.running_.erase(own);
    const auto next = all_.running_.lower_bound({who_.first, ""});
    const bool others = next != all_.running_.end() && next->first.first == who_.first;
    const auto last = all_.progress_.find(who_.first);
    if (last == all_.progress_.end()) return;
    if (!others) {
        all_.progress_.erase(last);
    } else if (last->second.kind == who_.second) {
        last->second.number = ++all_.reports_, last->second.fraction = 1;
        all_.told_.notify_all();
    }
}

Job LatestWork::Turn::job(int threads) const {
    return {.progress =
                [this](const Progress& progress) {
                    all_.report(who_.first, {.kind = who_.second,
                                             .stage = std::string(progress.stage),
                                             .fraction = progress.fraction});
                },
            .stop = stop(),
            .threads = threads};
}

void LatestWork::end_all() {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
    for (auto& [who, stop] : running_) stop.request_stop();
    told_.notify_all();
}

void LatestWork::report(const std::string& client, WorkProgress progress) {
    const std::scoped_lock lock(mutex_);
    progress.number = ++reports_;
    progress_.insert_or_assign(client, std::move(progress));
    told_.notify_all();
}

std::optional<WorkProgress> LatestWork::next_progress(const std::string& client,
                                                      std::uint64_t after,
                                                      const std::stop_token& stop) {
    constexpr std::chrono::milliseconds patience{500};
    std::unique_lock lock(mutex_);
    const auto is_new = [&] {
        const auto found = progress_.find(client);
        return found != progress_.end() && found->second.number > after;
    };
    if (!told_.wait_for(lock, stop, patience, is_new)) return {};
    return progress_.at(client);
}

} // namespace keiko::viewer
