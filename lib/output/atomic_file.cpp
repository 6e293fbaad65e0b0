// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

/// Sends what the kernel holds of a file, or of a folder's list of names, to the disk.
void flush_to_disk(const fs::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC);
  if (descriptor < 0) throw_system_error("open", path, errno);
  const int failure = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  // Some file systems cannot flush a folder; the rename is then as safe as they make it.
  if (failure != 0 && failure != EINVAL) throw_system_error("write", path, failure);
}

class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

void throw_system_error(const std::string& action, const fs::path& path, int error_number) {
  throw MissingResourceError(
      fmt::format("cannot {} '{}': {}", action, path.string(), std::generic_category().message(error_number)));
}

void write_atomically(const fs::path& target, const std::function<void(const fs::path&)>& write) {
  const TemporaryFile temporary(target.parent_path() / ("." + target.filename().string() + ".part"));
  write(temporary.path());
  flush_to_disk(temporary.path(), O_RDONLY);
  std::error_code error;
  fs::rename(temporary.path(), target, error);
  if (error) throw_system_error("write", target, error.value());
  flush_to_disk(target.has_parent_path() ? target.parent_path() : fs::path("."), O_RDONLY | O_DIRECTORY);
}

void write_text_atomically(const fs::path& target, std::string_view text) {
  write_atomically(target, [&](const fs::path& temporary) {
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream << text << std::flush;
    if (!stream) throw_system_error("write", target, errno);
  });
}

std::string read_text(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw InputError(fmt::format("'{}' is a folder, not a file", path.string()));
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw InputError(fmt::format("cannot read '{}': {}", path.string(), std::generic_category().message(errno)));
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void ensure_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw_system_error("make the folder", folder, error.value());
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw_system_error("remove", file, error.value());
}

}  // namespace anvil
