#include "sundrape/app/interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace sundrape {
namespace {

volatile std::sig_atomic_t interrupted = 0;  // a signal handler can reach nothing else

extern "C" void remember(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  interrupted = 0;
  for (const int signal : {SIGINT, SIGTERM})
    if (std::signal(signal, remember) == SIG_IGN) std::signal(signal, SIG_IGN);  // nohup and the like
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::requested() { return interrupted != 0; }

}  // namespace sundrape
