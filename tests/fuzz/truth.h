#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "core/csg/expression_grammar.h"

namespace strata::fuzz {

/// 64 assignments of truth values to the names of an expression at once.
struct Truth {
  std::uint64_t bits = 0;

  friend Truth operator|(Truth a, Truth b) { return {a.bits | b.bits}; }
  friend Truth operator&(Truth a, Truth b) { return {a.bits & b.bits}; }
  friend Truth operator^(Truth a, Truth b) { return {a.bits ^ b.bits}; }
  friend Truth operator-(Truth a, Truth b) { return {a.bits & ~b.bits}; }
  friend Truth operator~(Truth a) { return {~a.bits}; }
  friend bool operator==(Truth, Truth) = default;
};

/// Values of a name that look random: FNV-1a (Fowler, Noll, Vo), mixed as in SplitMix64.
inline Truth truth_of_name(std::string_view name) {
  std::uint64_t z = 0xcbf29ce484222325U;
  for (const char c : name) z = (z ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return {z ^ (z >> 31)};
}

/// Throws ParseError.
inline Truth truth_of(std::string_view expression) {
  const auto leaf = [](const std::string& name) { return truth_of_name(name); };
  return ExpressionGrammar<Truth, decltype(leaf)>(expression, leaf).parse();
}

}  // namespace strata::fuzz
