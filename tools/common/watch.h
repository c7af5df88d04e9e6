#pragma once
#include <mutex>
#include <string>
#include <thread>

#include "core/system/stop_bell.h"
#include "strata/monitor.h"

/// What a stop (Ctrl-C, SIGTERM, the time limit) does at the moment.
enum class OnStop {
  leave,   ///< nothing is written yet: end the process at once
  ask,     ///< set the cancel token, so that the engine throws Cancelled; after two seconds, as `leave`
  hold,    ///< set the cancel token, and leave it at that: something is done that must be whole
  finish,  ///< files are being written: too late to stop
};

/// Watches for signals and the time limit on a thread of its own. One per process.
class Watch {
 public:
  /// Starts in `leave`. `seconds` counts from here; 0 is no limit.
  explicit Watch(double seconds);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Throws strata::Cancelled when a stop came before.
  void on_stop(OnStop action);

  /// The same as on_stop(OnStop::hold), but goes on when a stop came before. Never throws.
  void hold();

  /// Why it was stopped; empty if it was not.
  [[nodiscard]] std::string reason();

  [[nodiscard]] const strata::CancelToken& token() const { return stopped_; }

 private:
  void run();
  void stop(const std::string& reason);
  void leave_if_still_asked();

  double seconds_;
  strata::system::StopBell bell_;
  strata::CancelToken stopped_;
  std::mutex mutex_;  // guards action_ and reason_
  OnStop action_ = OnStop::leave;
  std::string reason_;
  std::thread thread_;
};
