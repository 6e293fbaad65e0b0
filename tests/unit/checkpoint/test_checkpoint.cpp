// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/checkpoint/checkpoint.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/output/hdf5_file.hpp"
#include "unit/output/temporary_folder.hpp"

namespace anvil {
namespace {

Checkpoint make_checkpoint() {
  Checkpoint checkpoint;
  checkpoint.scene_name = "rod";
  checkpoint.scene_text = "title = \"Rod, 2 µm\"\n";
  checkpoint.version = "0.1.0";
  checkpoint.commit = "abc-modified";
  checkpoint.time = 0.1 + 0.2;
  checkpoint.step = 9'007'199'254'740'993;  // no double holds it
  checkpoint.next_frame = 12;
  checkpoint.history_rows = 345;
  checkpoint.state["field/velocity"] = {
      3, std::vector<double>{0.1, -0.0, 5e-324, std::numeric_limits<double>::infinity(),
                             std::bit_cast<double>(0x7ff8'0000'dead'beefULL), 1.0 / 3.0}};
  checkpoint.state["neighbours"] = {1, std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min(), 0, 42}};
  checkpoint.state["nothing"] = {2, std::vector<double>{}};
  return checkpoint;
}

std::vector<std::uint64_t> bits(const StateArray& array) {
  std::vector<std::uint64_t> result;
  for (const double number : std::get<std::vector<double>>(array.values))
    result.push_back(std::bit_cast<std::uint64_t>(number));
  return result;
}

TEST(Checkpoint, KeepsEveryBit) {
  const TemporaryFolder folder;
  const Checkpoint written = make_checkpoint();
  write_checkpoint(folder / "checkpoint_1.h5", written);
  Checkpoint read = read_checkpoint(folder / "checkpoint_1.h5");
  EXPECT_EQ(read.scene_name, written.scene_name);
  EXPECT_EQ(read.scene_text, written.scene_text);
  EXPECT_EQ(read.version, written.version);
  EXPECT_EQ(read.commit, written.commit);
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.step, written.step);
  EXPECT_EQ(read.next_frame, written.next_frame);
  EXPECT_EQ(read.history_rows, written.history_rows);
  ASSERT_EQ(read.state.size(), written.state.size());
  EXPECT_EQ(bits(read.state["field/velocity"]), bits(written.state.at("field/velocity")));
  EXPECT_EQ(read.state["field/velocity"].components, 3);
  EXPECT_EQ(read.state["neighbours"].values, written.state.at("neighbours").values);
  EXPECT_EQ(read.state["nothing"].components, 2);
  EXPECT_TRUE(bits(read.state["nothing"]).empty());
}

TEST(Checkpoint, OfTheSameStateIsTheSameFile) {
  const TemporaryFolder folder;
  write_checkpoint(folder / "a.h5", make_checkpoint());
  write_checkpoint(folder / "b.h5", make_checkpoint());
  EXPECT_EQ(read_text(folder / "a.h5"), read_text(folder / "b.h5"));
}

TEST(Checkpoint, RefusesFilesCutOffAnywhere) {
  const TemporaryFolder folder;
  write_checkpoint(folder / "whole.h5", make_checkpoint());
  const std::string whole = read_text(folder / "whole.h5");
  for (std::size_t size = 0; size < whole.size(); size += whole.size() / 17) {
    write_file(folder / "cut.h5", std::string_view(whole).substr(0, size));
    EXPECT_THROW(read_checkpoint(folder / "cut.h5"), InputError) << size << " of " << whole.size() << " bytes";
  }
}

TEST(Checkpoint, NoticesAFlippedBit) {
  const TemporaryFolder folder;
  Checkpoint checkpoint = make_checkpoint();
  checkpoint.state["field/velocity"] = {1, std::vector<double>(1000, 1.0 / 3.0)};
  write_checkpoint(folder / "whole.h5", checkpoint);
  std::string text = read_text(folder / "whole.h5");
  const double third = 1.0 / 3.0;
  const std::string pattern(reinterpret_cast<const char*>(&third), sizeof third);
  const std::size_t place = text.find(pattern + pattern);
  ASSERT_NE(place, std::string::npos);
  text[place] = static_cast<char>(text[place] ^ 1);
  write_file(folder / "flipped.h5", text);
  EXPECT_THROW(read_checkpoint(folder / "flipped.h5"), InputError);
}

TEST(Checkpoint, RefusesForeignFiles) {
  const TemporaryFolder folder;
  write_file(folder / "text.h5", "not a checkpoint");
  EXPECT_THROW(read_checkpoint(folder / "text.h5"), InputError);
  EXPECT_THROW(read_checkpoint(folder / "absent.h5"), InputError);
  Hdf5File::create(folder / "frame.h5", "anvil frame 1").close();
  try {
    read_checkpoint(folder / "frame.h5");
    FAIL() << "took a frame for a checkpoint";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("anvil frame 1"), std::string::npos) << error.what();
  }
}

TEST(Checkpoint, NamesAFolderThatIsMissing) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_checkpoint(folder / "missing/checkpoint_1.h5", make_checkpoint()), MissingResourceError);
}

}  // namespace
}  // namespace anvil
