#pragma once
/// The version of these headers. Before 1.0 a minor version may change what is public; a patch does not.

#define STRATA_VERSION_MAJOR 0
#define STRATA_VERSION_MINOR 1
#define STRATA_VERSION_PATCH 0
