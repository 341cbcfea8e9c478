#include "keiko/base/parallel.h"

#include "keiko/base/job.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace keiko {
namespace {

/// Order for the thread sanitizer that it cannot observe, because the library that ensures it is
/// not instrumented: what came before any `before()` came before what follows an `after()`. Does
/// nothing in other builds.
class TsanAnnotations {
public:
#if defined(__SANITIZE_THREAD__)
    void before() {
        __tsan_release(this);
    }
    void after() {
        __tsan_acquire(this);
    }
#else
    void before() {}
    void after() {}
#endif
};

/// One of several scopes that a library runs one after the other, on whatever threads.
class Turn {
public:
    explicit Turn(TsanAnnotations& order) : order_(order) { order_.after(); }
    ~Turn() { order_.before(); }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

private:
    TsanAnnotations& order_;
};

/// A callable that a library copies from thread to thread: whoever calls it knows what was written
/// before it was copied, what it has captured among it. Copied for each call: for callables that
/// only refer to what they work on.
template <class Callable>
class AnnotatedCallable {
public:
    explicit AnnotatedCallable(Callable callable) : callable_(std::move(callable)) {
        order_.before();
    }
    AnnotatedCallable(const AnnotatedCallable& other)
        : callable_((order_.after(), other.callable_)) {
        order_.before();
    }
    AnnotatedCallable& operator=(const AnnotatedCallable&) = delete;

    template <class... Arguments>
    auto operator()(Arguments&&... arguments) const {
        order_.after();
        const Callable own = callable_;
        order_.before(); // the library may make another copy in this one's memory
        return own(std::forward<Arguments>(arguments)...);
    }

private:
    static inline TsanAnnotations order_;
    Callable callable_;
};

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

/// Number of threads of an arena; oneTBB warns aloud about more threads than there are cores.
int arena_size(int threads) {
    const int cores = tbb::this_task_arena::max_concurrency();
    return threads > 0 ? std::min(threads, cores) : cores;
}

} // namespace

void parallel_for(std::size_t count, const Job& job, std::string_view stage,
                  const std::function<void(std::size_t)>& body) {
    StageProgress progress(job, stage, count);
    const StopScope scope(job);
    TsanAnnotations end;
    tbb::task_arena arena(arena_size(job.threads));
    arena.execute([&] {
        // simple_partitioner: one task an index, so that a stop request is seen soon.
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1),
                          AnnotatedCallable([&](const tbb::blocked_range<std::size_t>& range) {
                              const StopScope::Shared shared(&scope);
                              for (std::size_t i = range.begin(); i != range.end(); ++i) {
                                  check_stop();
                                  body(i);
                                  progress.one_done();
                              }
                              end.before();
                          }),
                          tbb::simple_partitioner{});
    });
    end.after();
}

void parallel_stream(std::size_t slots, const Job& job, const StreamStages& stages) {
    const StopScope scope(job);
    std::size_t begun = 0;
    std::atomic<bool> enough = false;
    TsanAnnotations reads, writes;
    std::vector<TsanAnnotations> stages_of(slots);
    // At most `slots` are under way and they are written in order: the next one is free again.
    const AnnotatedCallable read([&](tbb::flow_control& control) -> std::size_t {
        const StopScope::Shared shared(&scope);
        const Turn turn(reads);
        check_stop();
        const std::size_t slot = begun++ % slots;
        const Turn stage(stages_of[slot]);
        if (enough || !stages.read(slot)) control.stop();
        return slot;
    });
    const AnnotatedCallable work([&](std::size_t slot) {
        const StopScope::Shared shared(&scope);
        const Turn stage(stages_of[slot]);
        if (!enough) stages.work(slot);
        return slot;
    });
    const AnnotatedCallable write([&](std::size_t slot) {
        const StopScope::Shared shared(&scope);
        const Turn turn(writes), stage(stages_of[slot]);
        check_stop();
        if (!enough && !stages.write(slot)) enough = true;
    });
    reads.before();
    using tbb::filter_mode;
    tbb::task_arena arena(arena_size(job.threads));
    arena.execute([&] {
        tbb::parallel_pipeline(
            slots, tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, read) &
                       tbb::make_filter<std::size_t, std::size_t>(filter_mode::parallel, work) &
                       tbb::make_filter<std::size_t, void>(filter_mode::serial_in_order, write));
    });
    reads.after(), writes.after();
    for (TsanAnnotations& stages_done : stages_of) stages_done.after();
}

std::size_t thread_count(const Job& job) {
    return static_cast<std::size_t>(arena_size(job.threads));
}

} // namespace keiko
