#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

/// The least number of letters inserted, deleted, replaced or exchanged with their neighbour, no letter twice, that
/// makes b of a. Zero only for equal words; symmetric. O(|a| |b|). Source: Damerau 1964 (restricted edits).
[[nodiscard]] std::size_t edits(std::string_view a, std::string_view b);

/// What was probably meant by a word: the candidate that it begins, if it has three letters and begins one only; else
/// the one with the fewest edits, which must be at most a third of the word's length, rounded up. Of several the first.
/// Empty where none is near.
[[nodiscard]] std::string nearest(std::string_view word, std::span<const std::string> candidates);
