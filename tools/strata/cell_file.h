#pragma once
#include <string>

#include "strata/bsp/partition.h"

/// Writes the inside leaves of a bounded region as convex cells, pulled apart from the middle of the region and
/// coloured in turn, as glTF 2.0 (.glb). In units of the region's size, since glTF has floats only. Throws
/// strata::IoError.
void write_cells(const std::string& path, const strata::bsp::Partition<3>& region);
