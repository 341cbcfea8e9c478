#pragma once

#include "keiko/math/taylor_model.h"

namespace keiko {

/// The square root of a model; its error is infinite where the model may be 0 or less.
TaylorModel sqrt(const TaylorModel& model);

/// The model to the power -3/2; its error is infinite where the model may be 0 or less.
TaylorModel inverse_cubed_root(const TaylorModel& model);

} // namespace keiko
