#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "settings.h"
#include "strata/options.h"
#include "strata/transform.h"

/// A solid in a steps document: a file, how to read it and where to put it.
struct ChainOperand {
  std::string place;  ///< "start" or "steps[3]"
  std::string label;  ///< as its user calls it; may be empty
  std::string file;   ///< as the document has it
  std::string path;   ///< the same as seen from the current directory; "-" is standard input
  strata::InputClass input = strata::InputClass::automatic;
  strata::Transform transform;
  strata::Placement placement = strata::Placement::exact;

  [[nodiscard]] std::string title() const;  ///< for messages: "steps[3] (hole)"
};

struct ChainStep {
  strata::Operation operation = strata::Operation::union_;
  ChainOperand operand;
};

/// What `strata chain` reads: chain.md.
struct ChainDocument {
  std::string name;                   ///< for messages
  std::optional<ChainOperand> start;  ///< none: the empty solid
  std::vector<ChainStep> steps;
};

/// Reads a steps document, from standard input for "-". Paths in it are relative to its directory. What it does not say
/// about input classes and the placement of transforms is as in the settings. Reads no operand. Throws strata::IoError
/// with line and column, or with the place in the document; of several errors the first.
[[nodiscard]] ChainDocument read_chain_document(const std::string& path, const Settings& settings);

/// The same for the text of the document; `path` says where its operands are looked for, and stands for it in messages.
[[nodiscard]] ChainDocument parse_chain_document(std::string_view text, const std::string& path,
                                                 const Settings& settings);
