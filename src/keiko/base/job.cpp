#include "keiko/base/job.h"

#include "keiko/base/error.h"

namespace keiko {

void Job::check() const {
    if (stop.stop_requested()) throw Cancelled();
}

} // namespace keiko
