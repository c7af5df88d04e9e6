#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "chain_marks.h"
#include "settings.h"
#include "strata/solid.h"
#include "strata/unit.h"

/// How far a chain has come. As a file it is XOFF, so that every verb reads it; its first line is a comment with the
/// number of steps done, the unit, the marks of these steps and the SHA-256 of all other lines: chain.md.
struct ChainCheckpoint {
  std::size_t done = 0;                    ///< steps
  strata::Solid solid;                     ///< after these; without attributes, when read
  strata::Unit unit = strata::Unit::none;  ///< of its coordinates
};

/// Writes whole or not at all. Throws strata::IoError.
void write_checkpoint(const std::string& path, const ChainCheckpoint& checkpoint, const std::vector<ChainMark>& marks,
                      const Settings& settings);

/// Throws strata::IoError for what is no checkpoint, was changed since, or belongs to other steps than the marks say;
/// then it tells which step is the first that differs.
[[nodiscard]] ChainCheckpoint read_checkpoint(const std::string& path, const std::vector<ChainMark>& marks,
                                              const Settings& settings);

/// Throws strata::IoError where no file can be made under that name; changes nothing.
void require_writable(const std::string& path);
