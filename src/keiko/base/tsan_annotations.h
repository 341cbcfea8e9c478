#pragma once

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

#include <utility>

namespace keiko {

/// Tells the thread sanitizer an order that it cannot see, because the library that ensures it is
/// not instrumented: what came before any `before()` came before what follows an `after()`.
/// Nothing in other builds.
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

} // namespace keiko
