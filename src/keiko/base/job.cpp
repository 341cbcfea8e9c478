#include "keiko/base/job.h"

#include "keiko/base/error.h"

#include <utility>

namespace keiko {
namespace {

thread_local const StopScope* innermost_scope = nullptr;

} // namespace

void Job::check() const {
    if (stop.stop_requested()) throw Cancelled();
    check_stop();
}

StopScope::StopScope(StopQuery requested)
    : requested_(std::move(requested)), outer_(std::exchange(innermost_scope, this)) {}

StopScope::StopScope(const Job& job)
    : StopScope([stop = job.stop] { return stop.stop_requested(); }) {}

StopScope::~StopScope() {
    innermost_scope = outer_;
}

bool StopScope::stop_requested() const {
    for (const StopScope* scope = this; scope; scope = scope->outer_)
        if (scope->requested_()) return true;
    return false;
}

const StopScope* StopScope::innermost() {
    return innermost_scope;
}

StopScope::Shared::Shared(const StopScope* scope)
    : before_(std::exchange(innermost_scope, scope)) {}

StopScope::Shared::~Shared() {
    innermost_scope = before_;
}

void check_stop() {
    if (innermost_scope && innermost_scope->stop_requested()) throw Cancelled();
}

} // namespace keiko
