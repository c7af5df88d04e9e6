#pragma once
#include <string>
#include <vector>

#include "common/watch.h"

/// What the program OpenSCAD writes for a .scad file with `-o model.csg`, with NAME=VALUE definitions. Throws
/// strata::IoError where there is no such program, and with what it says where it fails; strata::Cancelled.
[[nodiscard]] std::string csg_of(const std::string& scad, const std::vector<std::string>& definitions,
                                 const std::string& program, const Watch& watch);
