// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/interruption.hpp"

#include <unistd.h>

#include <array>
#include <csignal>

namespace percolith::cli {
namespace {

// A signal handler can reach nothing but objects of static storage.
volatile std::sig_atomic_t is_asking = 0;
volatile std::sig_atomic_t received = 0;

extern "C" void handle_interruption(int number) {
  // Whoever stops jobs may send SIGTERM more than once (`timeout` does); only a person at the
  // keyboard insists.
  if (is_asking == 0 || (received != 0 && number == SIGINT)) {
    ::_exit(128 + number);
  }
  if (received == 0) {
    received = number;
  }
}

void set_handler(int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

constexpr std::array<int, 2> asking_signals = {SIGINT, SIGTERM};
constexpr std::array<int, 2> ignored_signals = {SIGPIPE, SIGXFSZ};

}  // namespace

Interruption::Interruption() {
  received = 0;
  for (const int number : asking_signals) {
    set_handler(number, handle_interruption);
  }
  for (const int number : ignored_signals) {
    set_handler(number, SIG_IGN);
  }
}

Interruption::~Interruption() {
  is_asking = 0;
  for (const int number : asking_signals) {
    set_handler(number, SIG_DFL);
  }
  for (const int number : ignored_signals) {
    set_handler(number, SIG_DFL);
  }
}

void Interruption::begin() {
  is_asking = 1;
}

int Interruption::signal() const {
  return received;
}

}  // namespace percolith::cli
