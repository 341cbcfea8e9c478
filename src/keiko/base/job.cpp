#include "keiko/base/job.h"

#include "keiko/base/error.h"
#include "keiko/base/stop_scope.h"

namespace keiko {

void Job::check() const {
    if (stop.stop_requested()) throw Cancelled();
    check_stop();
}

} // namespace keiko
