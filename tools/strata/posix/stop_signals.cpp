#include "stop_signals.h"

namespace {

strata::CancelToken stopped;

void handle(int /*number*/) { stopped.cancel(); }

}  // namespace

StopSignals::StopSignals() {
  struct sigaction action = {};
  action.sa_handler = handle;
  sigprocmask(SIG_BLOCK, nullptr, &before_);
  sigaction(SIGINT, &action, &interrupt_);
  sigaction(SIGTERM, &action, &terminate_);
  action.sa_handler = SIG_IGN;  // a closed pipe is a write error like any other
  sigaction(SIGPIPE, &action, &pipe_);
}

StopSignals::~StopSignals() {
  sigprocmask(SIG_SETMASK, &before_, nullptr);
  sigaction(SIGINT, &interrupt_, nullptr);
  sigaction(SIGTERM, &terminate_, nullptr);
  sigaction(SIGPIPE, &pipe_, nullptr);
}

const strata::CancelToken& StopSignals::token() const { return stopped; }

void StopSignals::hold() {
  sigset_t both;
  sigemptyset(&both);
  sigaddset(&both, SIGINT);
  sigaddset(&both, SIGTERM);
  sigprocmask(SIG_BLOCK, &both, nullptr);
}
