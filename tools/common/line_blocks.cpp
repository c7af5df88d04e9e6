#include "common/line_blocks.h"

#include <algorithm>
#include <utility>

#include "strata/errors.h"

bool LineBlocks::next(LineBlock& block) {
  if (!back_.text.empty()) {
    std::swap(block, back_);
    back_.text.clear();
    return true;
  }
  constexpr std::size_t size = std::size_t{1} << 19, longest = std::size_t{1} << 26;
  std::string& text = block.text;
  text.swap(begun_);
  begun_.clear();
  while (true) {
    const std::size_t before = text.size();
    if (before > longest) throw strata::IoError(source_.name(), {line_, {}}, "the line is too long for a table");
    text.resize(before + size);
    const std::size_t got = source_.read(text.data() + before, size);
    text.resize(before + got);
    if (got == 0) break;
    const auto last = std::find(text.rbegin(), text.rbegin() + static_cast<std::ptrdiff_t>(got), '\n').base();
    if (last == text.begin() + static_cast<std::ptrdiff_t>(before)) continue;
    begun_.assign(last, text.end());
    text.erase(last, text.end());
    break;
  }
  block.first_line = line_;
  line_ += static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
  return !text.empty();
}

void LineBlocks::put_back(LineBlock block) { back_ = std::move(block); }
