#include "paver/signals.h"

#include <signal.h>

#include <atomic>

namespace paver {
namespace {

std::atomic<Progress*> signalled{nullptr};  // signal handlers have no other way to reach it
static_assert(std::atomic<Progress*>::is_always_lock_free);

void handle_signal(int) {
  if (Progress* progress = signalled.load()) progress->cancel();
}

}  // namespace

void cancel_on_signals(Progress& progress) {
  signalled.store(&progress);
  struct sigaction action = {};
  action.sa_handler = handle_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (int number : {SIGINT, SIGTERM, SIGHUP}) sigaction(number, &action, nullptr);
  action.sa_handler = SIG_IGN;
  for (int number : {SIGXFSZ, SIGPIPE}) sigaction(number, &action, nullptr);
}

}  // namespace paver
