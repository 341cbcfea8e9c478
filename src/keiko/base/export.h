#pragma once

/// @namespace keiko
/// Surface quality by the reflections of lamps. The headers of api name the verbs, by group.

/// Marks the namespace of an installed header: what it declares is visible outside of the library.
/// Everything else is hidden (-fvisibility=hidden). tests/public_headers.py marks exactly the
/// headers that those of `api` reach.
#define KEIKO_API [[gnu::visibility("default")]]
