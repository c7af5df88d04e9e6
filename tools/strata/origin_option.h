#pragma once
#include <optional>
#include <string>

#include "report.h"
#include "strata/query.h"

/// The origin that --origin asks for: x,y,z or direction:x,y,z; nothing for auto. Throws UsageError.
[[nodiscard]] std::optional<strata::Origin> parse_origin(const std::string& text);

/// {kind: point or direction, at: [x, y, z]}
[[nodiscard]] Json to_json(const strata::Origin& origin);
