#pragma once
#include <string>

#include "strata/plane.h"

/// The plane `a,b,c,d` of the points with a x + b y + c z = d. Numbers are doubles or fractions: 1,0,0,1/3. Throws
/// UsageError.
[[nodiscard]] strata::Plane parse_plane(const std::string& text);
