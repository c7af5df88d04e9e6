#pragma once
#include <chrono>

/// A progress bar on stderr: after a second when that is a terminal; at once, and as plain lines elsewhere, when
/// asked for.
class ProgressBar {
 public:
  ProgressBar(bool asked, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Shows a fraction 0..1. Never called concurrently; may be called from any thread.
  void show(double fraction);

 private:
  void draw_bar(double fraction);
  void print_line(double fraction);

  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool asked_;
  bool silent_;
  Clock::time_point next_;  // when the bar may change again
  bool drawn_ = false;
  int printed_ = -1;  // tenths already printed
};
