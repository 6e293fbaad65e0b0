// SPDX-License-Identifier: BSD-3-Clause
// Scenes that cannot be used, given to the reader and to the program: each has to be refused with a sentence that names
// the file, the line and the key, and leave nothing behind.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "anvil/core/error.hpp"
#include "anvil/scene/reader.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

const fs::path malformed_folder = ANVIL_SOURCE_DIR "/tests/robustness/malformed";

struct Malformed {
  std::string file;
  int line = 0;  // 0: the file as a whole
  std::string phrase;
};

std::ostream& operator<<(std::ostream& stream, const Malformed& malformed) { return stream << malformed.file; }

/// The table expected.txt: file | line | phrase.
std::vector<Malformed> malformed_scenes() {
  std::vector<Malformed> scenes;
  std::ifstream table(malformed_folder / "expected.txt");
  for (std::string row; std::getline(table, row);) {
    const auto first = row.find(" | ");
    const auto second = row.find(" | ", first + 3);
    if (row.starts_with('#') || second == std::string::npos) continue;
    scenes.push_back(
        {row.substr(0, first), std::stoi(row.substr(first + 3, second - first - 3)), row.substr(second + 3)});
  }
  return scenes;
}

/// Expects one line of the message to name the place and to hold the phrase.
void expect_named(const std::string& message, const Malformed& malformed) {
  const std::string place =
      malformed.line == 0 ? malformed.file + ": " : malformed.file + ":" + std::to_string(malformed.line) + ":";
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);)
    if (line.find(place) != std::string::npos && line.find(malformed.phrase) != std::string::npos) return;
  ADD_FAILURE() << "no line names " << place << " with: " << malformed.phrase << "\nin:\n" << message;
}

/// A folder of its own for each test, removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "anvil_malformed_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { fs::remove_all(path_); }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

struct ProgramResult {
  int exit_code = -1;
  std::string text;  // of both streams
};

ProgramResult run_program(const fs::path& scene, const fs::path& results) {
  const std::string command = "'" ANVIL_PROGRAM "' run '" + scene.string() + "' -o '" + results.string() + "' 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("the program cannot be started");
  ProgramResult result;
  std::array<char, 4096> buffer{};
  for (std::size_t count = 1; count > 0;) {
    count = fread(buffer.data(), 1, buffer.size(), pipe);
    result.text.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

void expect_refused(const fs::path& scene, const Malformed& expected) {
  try {
    read_scene(scene);
    ADD_FAILURE() << "the reader accepts it";
  } catch (const InputError& error) {
    expect_named(error.what(), expected);
  }
  ASSERT_TRUE(fs::exists(ANVIL_PROGRAM));
  const TemporaryFolder folder;
  const fs::path results = folder.path() / "results";
  const ProgramResult result = run_program(scene, results);
  EXPECT_EQ(result.exit_code, static_cast<int>(ExitCode::bad_input)) << result.text;
  expect_named(result.text, expected);
  EXPECT_FALSE(fs::exists(results)) << "a refused scene leaves no results";
}

class MalformedScene : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedScene, IsRefused) { expect_refused(malformed_folder / GetParam().file, GetParam()); }

INSTANTIATE_TEST_SUITE_P(Files, MalformedScene, testing::ValuesIn(malformed_scenes()),
                         [](const auto& test) { return fs::path(test.param.file).stem().string(); });

TEST(MalformedScenes, TableNamesEveryFile) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(malformed_folder))
    files += entry.path().extension() == ".toml" ? 1 : 0;
  EXPECT_EQ(malformed_scenes().size(), files);
  EXPECT_GE(files, 40u);
}

/// What cannot be kept in a repository as a readable scene is written here.
class UnreadableScene : public testing::Test {
 protected:
  fs::path write(const std::string& bytes) const {
    const fs::path file = folder_.path() / "scene.toml";
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }
  TemporaryFolder folder_;
};

TEST_F(UnreadableScene, Empty) { expect_refused(write(""), {"scene.toml", 0, "the file is empty"}); }
TEST_F(UnreadableScene, Blank) { expect_refused(write(" \n\t\n"), {"scene.toml", 0, "the file is empty"}); }
TEST_F(UnreadableScene, OnlyAComment) {
  expect_refused(write("# nothing\n"), {"scene.toml", 0, "the scene has no [[body]]"});
}
TEST_F(UnreadableScene, Binary) {
  expect_refused(write(std::string("\x7f"
                                   "ELF\x02\x01\0\0\0",
                                   9)),
                 {"scene.toml", 0, "this is a binary file"});
}
TEST_F(UnreadableScene, NotUtf8) {
  expect_refused(write("title = \"\xff\xfe\"\n"), {"scene.toml", 1, "not valid TOML"});
}
TEST_F(UnreadableScene, DeeplyNested) {
  expect_refused(write("title = " + std::string(100000, '[') + "\n"), {"scene.toml", 1, "not valid TOML"});
}
TEST_F(UnreadableScene, VeryLongKey) {
  expect_refused(write(std::string(100000, 'k') + " = 1\n"), {"scene.toml", 1, "is unknown"});
}
TEST_F(UnreadableScene, TooLarge) {
  expect_refused(write(std::string((16u << 20) + 1, '#')), {"scene.toml", 0, "larger than 16 MiB"});
}
TEST_F(UnreadableScene, Missing) {
  const fs::path file = folder_.path() / "scene.toml";
  EXPECT_THROW(read_scene(file), InputError);
  const ProgramResult result = run_program(file, folder_.path() / "results");
  EXPECT_EQ(result.exit_code, static_cast<int>(ExitCode::bad_input));
  EXPECT_NE(result.text.find("scene.toml"), std::string::npos) << result.text;
  EXPECT_FALSE(fs::exists(folder_.path() / "results"));
}
TEST_F(UnreadableScene, Folder) {
  const fs::path file = folder_.path() / "scene.toml";
  fs::create_directory(file);
  expect_refused(file, {"scene.toml", 0, "this is a folder, not a file"});
}
TEST_F(UnreadableScene, WithoutPermission) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read every file";
  const fs::path file = write("title = 'secret'\n");
  fs::permissions(file, fs::perms::none);
  expect_refused(file, {"scene.toml", 0, "check its permissions"});
}
TEST_F(UnreadableScene, Endless) { EXPECT_THROW(read_scene("/dev/zero"), InputError); }

}  // namespace
}  // namespace anvil
