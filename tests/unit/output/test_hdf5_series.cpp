// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/hdf5_series.hpp"

#include <gtest/gtest.h>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "unit/output/temporary_folder.hpp"

namespace anvil {
namespace {

Frame make_frame(int index) {
  Frame frame;
  frame.scene = "rod";
  frame.time = 0.1 * index;
  frame.step = 7 * index;
  frame.index = index;
  frame.dimension = 2;
  frame.positions = {0.1, 0.2, 0.0, 1.0 / 3.0, -0.0, 0.0};
  frame.arrays = {{"density", "kg/m3", 1, false, {8930.0, 8931.1}},
                  {"particle_id", "", 1, true, {0.0, 1.0}},
                  {"stress", "Pa", 6, false, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}}};
  frame.provenance = {{"commit", "abc"}, {"title", "A rod"}};
  return frame;
}

TEST(Hdf5Series, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  Hdf5Series series(folder.path(), "rod");
  series.write(make_frame(3));
  const Frame frame = read_hdf5_frame(folder / "frames/rod_000003.h5");
  const Frame expected = make_frame(3);
  EXPECT_EQ(frame.scene, expected.scene);
  EXPECT_EQ(frame.time, expected.time);
  EXPECT_EQ(frame.step, expected.step);
  EXPECT_EQ(frame.index, expected.index);
  EXPECT_EQ(frame.dimension, expected.dimension);
  EXPECT_EQ(frame.positions, expected.positions);
  EXPECT_EQ(frame.provenance, expected.provenance);
  ASSERT_EQ(frame.arrays.size(), expected.arrays.size());
  for (const auto& array : expected.arrays) {
    ASSERT_NE(frame.find(array.name), nullptr) << array.name;
    EXPECT_EQ(frame.find(array.name)->unit, array.unit);
    EXPECT_EQ(frame.find(array.name)->components, array.components);
    EXPECT_EQ(frame.find(array.name)->integer, array.integer);
    EXPECT_EQ(frame.find(array.name)->values, array.values);
  }
}

TEST(Hdf5Series, GoesOnAfterTheFramesItKeeps) {
  const TemporaryFolder folder;
  {
    Hdf5Series series(folder.path(), "rod");
    for (int index = 0; index < 4; ++index) series.write(make_frame(index));
  }
  Hdf5Series(folder.path(), "rod", 2).write(make_frame(2));
  EXPECT_TRUE(std::filesystem::exists(folder / "frames/rod_000001.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder / "frames/rod_000002.h5"));
  EXPECT_FALSE(std::filesystem::exists(folder / "frames/rod_000003.h5"));
}

TEST(Hdf5Series, WritesTheSameBytesForTheSameFrame) {
  const TemporaryFolder first;
  const TemporaryFolder second;
  Hdf5Series(first.path(), "rod").write(make_frame(0));
  Hdf5Series(second.path(), "rod").write(make_frame(0));
  EXPECT_EQ(read_text(first / "frames/rod_000000.h5"), read_text(second / "frames/rod_000000.h5"));
}

TEST(Hdf5Series, RefusesFilesThatAreCutOffOrForeign) {
  const TemporaryFolder folder;
  Hdf5Series(folder.path(), "rod").write(make_frame(0));
  const std::string whole = read_text(folder / "frames/rod_000000.h5");
  for (const std::size_t size : {std::size_t{0}, whole.size() / 2, whole.size() - 1}) {
    write_file(folder / "cut.h5", std::string_view(whole).substr(0, size));
    EXPECT_THROW(read_hdf5_frame(folder / "cut.h5"), InputError) << size << " of " << whole.size() << " bytes";
  }
  write_file(folder / "text.h5", "no HDF5 at all");
  EXPECT_THROW(read_hdf5_frame(folder / "text.h5"), InputError);
  EXPECT_THROW(read_hdf5_frame(folder / "absent.h5"), InputError);
}

}  // namespace
}  // namespace anvil
