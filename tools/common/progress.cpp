#include "common/progress.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "common/tell.h"
#include "core/system/streams.h"

namespace {
constexpr auto patience = std::chrono::seconds(1);
constexpr auto pace = std::chrono::milliseconds(100);
constexpr int width = 40;
}  // namespace

ProgressBar::ProgressBar(bool asked, bool quiet)
    : terminal_(strata::system::is_terminal(strata::system::standard_error)),
      asked_(asked),
      silent_(!asked && (quiet || !terminal_)) {
  next_ = Clock::now();
  if (!asked_) next_ += patience;
}

ProgressBar::~ProgressBar() {
  if (drawn_) tell("\r{:{}}\r", "", width + 8);
}

void ProgressBar::show(double fraction) {
  if (silent_) return;
  fraction = std::clamp(fraction, 0.0, 1.0);
  if (terminal_) {
    draw_bar(fraction);
  } else {
    print_line(fraction);
  }
}

void ProgressBar::draw_bar(double fraction) {
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + pace;
  drawn_ = true;
  const auto filled = static_cast<std::size_t>(std::lround(fraction * width));
  tell("\r[{:<{}}] {:3.0f} %", std::string(filled, '#'), width, 100 * fraction);
}

void ProgressBar::print_line(double fraction) {
  const int tenths = static_cast<int>(10 * fraction);
  if (tenths <= printed_) return;
  printed_ = tenths;
  tell("strata: {} %\n", 10 * tenths);
}
