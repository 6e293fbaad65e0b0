// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/atomic_file.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "anvil/core/error.hpp"
#include "unit/output/temporary_folder.hpp"

namespace anvil {
namespace {

std::size_t count_files(const std::filesystem::path& folder) {
  const std::filesystem::directory_iterator files(folder);
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST(AtomicFile, ReplacesTheContentAndLeavesNothingElse) {
  const TemporaryFolder folder;
  write_text_atomically(folder / "a.txt", "first");
  write_text_atomically(folder / "a.txt", "second");
  EXPECT_EQ(read_text(folder / "a.txt"), "second");
  EXPECT_EQ(count_files(folder.path()), 1U);
}

TEST(AtomicFile, KeepsTheOldContentWhenWritingFails) {
  const TemporaryFolder folder;
  write_text_atomically(folder / "a.txt", "old");
  const auto fail_halfway = [](const std::filesystem::path& temporary) {
    write_file(temporary, "half of the n");
    throw std::runtime_error("interrupted");
  };
  EXPECT_THROW(write_atomically(folder / "a.txt", fail_halfway), std::runtime_error);
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
  EXPECT_EQ(count_files(folder.path()), 1U);
}

TEST(AtomicFile, ShowsTheTargetOnlyWhenItIsWhole) {
  const TemporaryFolder folder;
  write_atomically(folder / "a.txt", [&](const std::filesystem::path& temporary) {
    write_file(temporary, "text");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  });
  EXPECT_TRUE(std::filesystem::exists(folder / "a.txt"));
}

TEST(AtomicFile, NamesPathAndReason) {
  const TemporaryFolder folder;
  try {
    write_text_atomically(folder / "missing/a.txt", "text");
    FAIL() << "wrote into a folder that does not exist";
  } catch (const MissingResourceError& error) {
    EXPECT_NE(std::string(error.what()).find("missing/a.txt"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("No such file or directory"), std::string::npos) << error.what();
  }
}

TEST(ReadText, RefusesFoldersAndMissingFiles) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_text(folder.path()), InputError);
  EXPECT_THROW(read_text(folder / "absent"), InputError);
}

}  // namespace
}  // namespace anvil
