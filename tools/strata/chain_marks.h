#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "chain_document.h"
#include "common/json_location.h"

/// What of an operand and what is done with it the result depends on: neither labels nor names of files.
struct ChainMark {
  std::string operation;  ///< "start" of the start
  std::string file;       ///< SHA-256 of its content; empty: no file, the empty solid
  std::string input;      ///< class
  std::string transform;  ///< three rows of rationals, in lowest terms; empty: none
};

/// Marks of the start and of all steps, in this order. Reads each file once. Throws strata::IoError with the place in
/// the document; UsageError for operands from standard input, which nobody can look at again.
[[nodiscard]] std::vector<ChainMark> marks_of(const ChainDocument& document);

/// The first `count` marks: {"files": [digest...], "marks": [[operation, number of the file or null, input,
/// transform]...]}.
[[nodiscard]] Json to_json(const std::vector<ChainMark>& marks, std::size_t count);

/// The inverse. Throws strata::IoError.
[[nodiscard]] std::vector<ChainMark> read_marks(const JsonLocation& place);

/// What differs first: "steps[3].operation is union, was difference"; empty if one list begins as the other.
[[nodiscard]] std::string difference(const std::vector<ChainMark>& now, const std::vector<ChainMark>& before);
