#pragma once

#include "keiko/api/view.h"
#include "keiko/viewer/http_message.h"

#include <string>

namespace keiko::viewer {

/// Name of the page that asks, so that its newer requests end its older ones alone; empty without
/// one. Throws Error unless it is up to 64 letters, digits and hyphens.
std::string client_of(const HttpRequest& request);

/// The request of a body, keiko-view-request/1. Throws Error for another text, and for a picture of
/// more than 8388608 pixels.
ViewRequest request_of(const HttpRequest& request);

} // namespace keiko::viewer
