// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "anvil/core/error.hpp"
#include "vtk_io/display.hpp"

namespace anvil {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

/// A process that has started its own X server, told its number, and waits to be killed.
struct Drawer {
  pid_t process = 0;
  std::string display;  // ":1"; empty when it failed
};

pid_t start_drawer(int result) {
  const pid_t process = fork();
  if (process != 0) return process;
  unsetenv("DISPLAY");
  try {
    ensure_display();
    const std::string display = std::getenv("DISPLAY");
    if (write(result, display.data(), display.size()) < 0) _exit(1);
  } catch (const Error&) {
    _exit(1);
  }
  close(result);
  pause();
  _exit(0);
}

std::vector<Drawer> start_drawers(int count) {
  std::vector<Drawer> drawers;
  std::vector<int> pipes;
  for (int i = 0; i < count; ++i) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) break;
    drawers.push_back({start_drawer(ends[1]), ""});
    close(ends[1]);
    pipes.push_back(ends[0]);
  }
  for (std::size_t i = 0; i < pipes.size(); ++i) {
    std::array<char, 32> text{};
    if (const auto size = read(pipes[i], text.data(), text.size()); size > 0)
      drawers[i].display.assign(text.data(), static_cast<std::size_t>(size));
    close(pipes[i]);
  }
  return drawers;
}

fs::path socket_of(const Drawer& drawer) { return "/tmp/.X11-unix/X" + drawer.display.substr(1); }

TEST(Display, EveryOneOfManyProcessesGetsItsOwnAndLeavesNothing) {
  constexpr int count = 24;
  const auto drawers = start_drawers(count);
  ASSERT_EQ(drawers.size(), static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < drawers.size(); ++i) {
    ASSERT_FALSE(drawers[i].display.empty());
    EXPECT_TRUE(fs::exists(socket_of(drawers[i])));
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(drawers[i].display, drawers[j].display);
  }
  // SIGKILL leaves a process no chance to clean up behind itself.
  for (const Drawer& drawer : drawers) kill(drawer.process, SIGKILL);
  for (const Drawer& drawer : drawers) waitpid(drawer.process, nullptr, 0);
  const auto servers_left = [&] {
    int left = 0;
    for (const Drawer& drawer : drawers) left += fs::exists(socket_of(drawer)) ? 1 : 0;
    return left;
  };
  // An X server takes milliseconds to end; ten seconds are for a crowded machine.
  for (int i = 0; i < 100 && servers_left() > 0; ++i) std::this_thread::sleep_for(100ms);
  EXPECT_EQ(servers_left(), 0);
}

TEST(Display, SaysWhatToInstallWhereThereIsNone) {
  const auto draw_without_xvfb = [] {
    unsetenv("DISPLAY");
    setenv("PATH", "/nowhere", 1);
    try {
      ensure_display();
    } catch (const Error& error) {
      std::fputs(error.what(), stderr);
      std::exit(static_cast<int>(error.exit_code()));
    }
  };
  EXPECT_EXIT(draw_without_xvfb(), testing::ExitedWithCode(2), "packages xvfb and libgl1-mesa-dri");
}

}  // namespace
}  // namespace anvil
