// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/core/data_path.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "anvil/core/error.hpp"

namespace {

namespace fs = std::filesystem;

/// A bundled tree of our own at $ANVIL_DATA, removed at the end.
class OwnBundle : public ::testing::Test {
 protected:
  OwnBundle() : root_(fs::temp_directory_path() / ("anvil_bundle_" + std::to_string(::getpid()))) {
    fs::create_directories(root_ / "scenes");
    std::ofstream(root_ / "scenes" / "b.toml") << "title = 'b'\n";
    std::ofstream(root_ / "scenes" / "a.toml") << "title = 'a'\n";
    std::ofstream(root_ / "scenes" / "notes.txt") << "not a scene\n";
    std::ofstream(root_ / "secret.toml") << "title = 'secret'\n";
    ::setenv("ANVIL_DATA", root_.c_str(), 1);
  }
  ~OwnBundle() override {
    ::unsetenv("ANVIL_DATA");
    fs::remove_all(root_);
  }
  OwnBundle(const OwnBundle&) = delete;
  OwnBundle& operator=(const OwnBundle&) = delete;

  fs::path root_;
};

TEST_F(OwnBundle, IsSearchedFirst) {
  EXPECT_EQ(anvil::bundled_roots().front(), root_);
  EXPECT_EQ(anvil::find_bundled("scenes", "a.toml"), root_ / "scenes" / "a.toml");
}

TEST_F(OwnBundle, ListsItsFilesSortedAndByExtension) {
  const auto names = anvil::list_bundled("scenes", ".toml");
  const auto a = std::find(names.begin(), names.end(), "a.toml");
  const auto b = std::find(names.begin(), names.end(), "b.toml");
  EXPECT_NE(a, names.end());
  EXPECT_NE(b, names.end());
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(std::find(names.begin(), names.end(), "notes.txt"), names.end());
}

TEST_F(OwnBundle, AMissingFileIsNamedWithThePlacesSearched) {
  try {
    anvil::find_bundled("scenes", "absent.toml");
    FAIL() << "an absent file was found";
  } catch (const anvil::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("absent.toml"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find(root_.string()), std::string::npos);
  }
}

TEST_F(OwnBundle, NamesDoNotLeaveTheirFolder) {
  EXPECT_THROW(anvil::find_bundled("scenes", "../secret.toml"), anvil::InputError);
  EXPECT_THROW(anvil::find_bundled("scenes", (root_ / "secret.toml").string()), anvil::InputError);
  EXPECT_THROW(anvil::find_bundled("scenes", ""), anvil::InputError);
}

TEST(BundledFiles, OfTheSourceTreeAreFoundFromTheBuildTree) {
  ::unsetenv("ANVIL_DATA");
  const auto roots = anvil::bundled_roots();
  ASSERT_EQ(roots.size(), 1U);
  EXPECT_TRUE(fs::equivalent(roots.front(), fs::path(ANVIL_SOURCE_DIR) / "data"));
}

TEST(BundledFiles, AnUnusableEnvironmentVariableIsPassedOver) {
  ::setenv("ANVIL_DATA", "no/such/folder", 1);
  for (const auto& root : anvil::bundled_roots()) EXPECT_NE(root, fs::path("no/such/folder"));
  ::unsetenv("ANVIL_DATA");
}

}  // namespace
