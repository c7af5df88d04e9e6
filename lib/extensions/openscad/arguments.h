#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"

namespace strata::openscad {

/// The arguments of a node by their names. An argument without a name is for the next parameter that none before it was
/// for. Of two with one name the later is used; `undef` means that there is none. Arguments that a node does not have
/// are noted and ignored, except special variables ($t). The node must outlive this.
class Arguments {
 public:
  Arguments(const SyntaxNode& node, std::initializer_list<std::string_view> parameters, Report& report);

  /// Null where there is none.
  [[nodiscard]] const Value* find(std::string_view parameter) const;
  /// Throws CsgError for a value of another kind.
  [[nodiscard]] double number(std::string_view parameter, double otherwise) const;
  [[nodiscard]] bool truth(std::string_view parameter, bool otherwise) const;
  [[nodiscard]] std::string text(std::string_view parameter, const std::string& otherwise) const;
  /// Of a vector its first numbers, of a number as many of it; missing ones are `otherwise`.
  [[nodiscard]] std::vector<double> numbers(std::string_view parameter, std::vector<double> otherwise) const;
  /// The points of a vector of vectors with `dimension` finite numbers each; none where there is no such argument.
  [[nodiscard]] std::vector<std::vector<double>> points(std::string_view parameter, std::size_t dimension) const;
  [[nodiscard]] bool is_given(std::string_view parameter) const { return find(parameter) != nullptr; }

  /// Throws CsgError at the argument: "the PARAMETER of NODE REASON".
  [[noreturn]] void fail(std::string_view parameter, const std::string& reason) const;
  /// A note at the node: "NODE WHAT".
  void note(const std::string& what) const;

 private:
  struct Given {
    std::string_view parameter;
    const Argument* argument;
  };
  [[nodiscard]] const Given* given(std::string_view parameter) const;

  const SyntaxNode& node_;
  Report& report_;
  std::vector<Given> given_;
};

}  // namespace strata::openscad
