#include "keiko/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>

namespace keiko {
namespace {

/// Counts finished indices and hands the share on, one caller at a time.
class StageProgress {
public:
    StageProgress(const Job& job, std::string_view stage, std::size_t count)
        : job_(job), stage_(stage), count_(count) {}

    void one_done() {
        if (stage_.empty() || !job_.progress) return;
        const std::scoped_lock lock(mutex_);
        job_.report(stage_, static_cast<double>(++done_) / static_cast<double>(count_));
    }

private:
    const Job& job_;
    std::string_view stage_;
    std::size_t count_, done_ = 0;
    std::mutex mutex_;
};

/// oneTBB complains aloud when asked for more threads than there are cores.
int arena_size(int threads) {
    const int cores = tbb::this_task_arena::max_concurrency();
    return threads > 0 ? std::min(threads, cores) : cores;
}

} // namespace

void parallel_for(std::size_t count, const Job& job, std::string_view stage,
                  const std::function<void(std::size_t)>& body) {
    StageProgress progress(job, stage, count);
    tbb::task_arena arena(arena_size(job.threads));
    arena.execute([&] {
        // simple_partitioner: one task an index, so that a stop request is seen soon.
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
                for (std::size_t i = range.begin(); i != range.end(); ++i) {
                    job.check();
                    body(i);
                    progress.one_done();
                }
            },
            tbb::simple_partitioner{});
    });
}

} // namespace keiko
