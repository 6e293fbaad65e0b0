// SPDX-License-Identifier: BSD-3-Clause
#include "vtk_io/display.hpp"

#include <X11/Xlib.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <mutex>
#include <string>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr int start_attempts = 3;
constexpr int start_timeout = 20000;  // ms: Xvfb starts in 0.1 s, on a crowded machine in a few seconds

bool has_usable_display() {
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr) return false;
  int opcode = 0;
  int event = 0;
  int error = 0;
  const bool has_opengl = XQueryExtension(display, "GLX", &opcode, &event, &error) != 0;
  XCloseDisplay(display);
  return has_opengl;
}

/// What the child does between fork and exec: only calls that are safe there.
[[noreturn]] void become_xvfb(pid_t parent, int number_pipe) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  // SIGTERM and not SIGKILL: Xvfb then removes its lock file and its socket.
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(127);
  setpgid(0, 0);  // Ctrl-C is for the parent
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  constexpr int number_descriptor = 3;
  if (number_pipe == number_descriptor)
    fcntl(number_pipe, F_SETFD, 0);
  else
    dup2(number_pipe, number_descriptor);
  execlp("Xvfb", "Xvfb", "-displayfd", "3", "-noreset", "-nolisten", "tcp", "-screen", "0", "1600x1200x24", nullptr);
  _exit(127);
}

/// The line that Xvfb writes once it accepts connections: the number of its display. Empty when it ended or is late.
std::string read_number(int pipe) {
  std::string number;
  pollfd readable{pipe, POLLIN, 0};
  while (poll(&readable, 1, start_timeout) > 0) {
    char character = 0;
    if (read(pipe, &character, 1) != 1) return "";
    if (character == '\n') return number;
    number += character;
  }
  return "";
}

/// Starts Xvfb on the first free display, which it finds itself: any number of processes can do this at once.
std::string start_xvfb() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return "";
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) become_xvfb(parent, ends[1]);
  close(ends[1]);
  const std::string number = child < 0 ? "" : read_number(ends[0]);
  close(ends[0]);
  if (number.empty() && child > 0) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
  return number;
}

bool is_program_installed(const std::string& program) {
  const char* variable = std::getenv("PATH");
  const std::string folders = variable == nullptr ? "/usr/bin:/bin" : variable;
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    if (access((folders.substr(begin, end - begin) + "/" + program).c_str(), X_OK) == 0) return true;
    begin = end + 1;
  }
  return false;
}

}  // namespace

void ensure_display() {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  if (has_usable_display()) return;
  if (!is_program_installed("Xvfb"))
    throw MissingResourceError(
        "cannot draw: there is no X server with OpenGL, and Xvfb, which would stand in for one, is not installed. "
        "Install "
        "the packages xvfb and libgl1-mesa-dri");
  for (int attempt = 0; attempt < start_attempts; ++attempt) {
    const std::string number = start_xvfb();
    if (number.empty()) continue;
    setenv("DISPLAY", (":" + number).c_str(), 1);
    if (has_usable_display()) return;
  }
  throw MissingResourceError(
      "cannot draw: Xvfb does not start or has no OpenGL. Try 'Xvfb -displayfd 1', and check that the package "
      "libgl1-mesa-dri is installed");
}

}  // namespace anvil
