#pragma once

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace keiko {

/// Tells the thread sanitizer an order that it cannot see, because the library that ensures it is
/// not instrumented: what came before any `before()` came before what follows an `after()`.
/// Nothing in other builds.
class HappensBefore {
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
    explicit Turn(HappensBefore& order) : order_(order) { order_.after(); }
    ~Turn() { order_.before(); }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

private:
    HappensBefore& order_;
};

} // namespace keiko
