#pragma once
#include <map>
#include <string>
#include <utility>

#include "chain_document.h"
#include "files.h"
#include "report.h"
#include "strata/solid.h"
#include "strata/unit.h"

/// The solids that the operands of a chain are made of. Every file is read once, every solid checked once, before the
/// first step is done, so that nothing is computed in vain; each is dropped after its last use.
class ChainOperands {
 public:
  /// Names operands for messages in settings.operands: what is refused, or the solid before a step and its operand.
  /// Both must outlive this.
  ChainOperands(const ChainDocument& document, Settings& settings) : document_(document), settings_(settings) {}

  /// Reads what the start (unless it is not needed any more) and the steps from `first` on need, and converts all to
  /// `unit`, or if there is none to that of the first file that has one. Throws strata::IoError, UsageError and
  /// strata::InputError with the place in the document.
  void read(std::size_t first, bool with_start, strata::Unit unit = strata::Unit::none);

  /// The solid where the operand puts it. To be asked once for each operand that was read. Throws as `read` does.
  [[nodiscard]] strata::Solid take(const ChainOperand& operand);

  [[nodiscard]] strata::Unit unit() const { return unit_; }
  /// The materials of all files, as attributes.
  [[nodiscard]] const strata::Attributes& materials() const { return materials_; }

  /// Of all solids that were made of files, and of one that was refused, if a report was asked for.
  [[nodiscard]] const Json& reports() const { return reports_; }

 private:
  using Key = std::pair<std::string, strata::InputClass>;
  struct Stored {
    strata::Solid solid;
    std::size_t uses = 0;  ///< still to come
  };

  LoadedMesh load(const ChainOperand& operand);
  void store(const ChainOperand& operand, const LoadedMesh& mesh);
  void announce(const LoadedMesh& mesh, const strata::Solid& solid);
  void print_notes(const LoadedMesh& mesh, const strata::Solid& solid) const;
  LoadedMesh moved(const strata::Solid& solid, const ChainOperand& operand) const;
  strata::Solid make(const LoadedMesh& mesh, const ChainOperand& operand, strata::InputClass input);

  const ChainDocument& document_;
  Settings& settings_;
  std::map<Key, Stored> solids_;
  strata::Unit unit_ = strata::Unit::none;
  strata::Attributes materials_;
  Json reports_ = Json::array();
};
