// SPDX-License-Identifier: BSD-3-Clause
#include "movie.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>

#include <string>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"

extern char** environ;

namespace anvil {
namespace {

/// Runs a program of the path in silence and returns what it leaves to the shell, -1 when it cannot be started.
int run_silently(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, 2, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const int failure = posix_spawnp(&process, arguments[0], &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failure != 0) return -1;
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

std::filesystem::path PictureSeries::picture(std::size_t number) const {
  return folder / fmt::format("{}_{:06d}.png", name, number);
}

bool has_ffmpeg() { return run_silently({"ffmpeg", "-version"}) == 0; }

void make_film(const PictureSeries& pictures, double frames_per_second, const std::filesystem::path& film) {
  write_atomically(film, [&](const std::filesystem::path& temporary) {
    // The first filter makes sides even, which 4:2:0 needs.
    const int status =
        run_silently({"ffmpeg", "-y", "-framerate", fmt::format("{}", frames_per_second), "-i",
                      (pictures.folder / (pictures.name + "_%06d.png")).string(), "-vf",
                      "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264", "-crf", "18", "-pix_fmt",
                      "yuv420p", "-movflags", "+faststart", "-f", "mp4", temporary.string()});
    if (status != 0)
      throw MissingResourceError(fmt::format("ffmpeg could not make '{}' (exit code {}); its pictures are '{}'",
                                             film.string(), status, pictures.picture(0).string()));
  });
}

}  // namespace anvil
