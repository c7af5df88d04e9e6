#pragma once
/// The headers of Windows, some of which oneTBB includes, define common words as macros. This file is included before
/// every source, so that none of ours meets them.
#define NOMINMAX
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#undef near
#undef far
