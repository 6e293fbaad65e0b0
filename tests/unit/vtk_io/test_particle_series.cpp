// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/output/result_folder.hpp"
#include "render/mushroom.hpp"
#include "vtk_io/particle_reader.hpp"
#include "vtk_io/particle_series.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

class ParticleSeries : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "anvil_series_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write_frames(int from, int to, const SeriesFormat& format = {}) {
    ParticleSeriesWriter writer(folder_, "mushroom", format, from);
    for (int i = from; i < to; ++i) writer.write(test::make_mushroom(2, 0.1 * i, i));
  }

  fs::path folder_;
};

void expect_same(const FrameArray& written, const FrameArray& read, bool double_precision) {
  EXPECT_EQ(written.unit, read.unit);
  EXPECT_EQ(written.components, read.components);
  EXPECT_EQ(written.integer, read.integer);
  ASSERT_EQ(written.values.size(), read.values.size());
  for (std::size_t i = 0; i < written.values.size(); ++i) {
    const bool exact = double_precision || written.integer;
    ASSERT_EQ(read.values[i], exact ? written.values[i] : static_cast<double>(static_cast<float>(written.values[i])));
  }
}

TEST_F(ParticleSeries, ReadsBackWhatWasWrittenInEveryFormat) {
  for (const std::string format : {"vtp", "vtu"})
    for (const std::string precision : {"float32", "float64"})
      for (const std::string compression : {"lz4", "zlib", "none"}) {
        SCOPED_TRACE(format + " " + precision + " " + compression);
        write_frames(0, 1, {format, precision, compression});
        const Frame written = test::make_mushroom(2, 0.0, 0);
        const auto series = read_series(folder_);
        ASSERT_EQ(series.size(), 1U);
        EXPECT_EQ(series[0].file.extension(), "." + format);
        const Frame read = read_frame(series[0].file);
        EXPECT_EQ(read.scene, written.scene);
        EXPECT_EQ(read.time, written.time);
        EXPECT_EQ(read.step, written.step);
        EXPECT_EQ(read.index, written.index);
        EXPECT_EQ(read.dimension, written.dimension);
        EXPECT_EQ(read.provenance, written.provenance);
        ASSERT_EQ(read.arrays.size(), written.arrays.size());
        expect_same({"", "", 3, false, written.positions}, {"", "", 3, false, read.positions}, precision == "float64");
        for (const FrameArray& array : written.arrays) {
          SCOPED_TRACE(array.name);
          ASSERT_NE(read.find(array.name), nullptr);
          expect_same(array, *read.find(array.name), precision == "float64");
        }
      }
}

TEST_F(ParticleSeries, ListsEveryFrameWithItsExactTime) {
  write_frames(0, 5);
  const auto series = read_series(folder_ / "mushroom.pvd");
  ASSERT_EQ(series.size(), 5U);
  for (int i = 0; i < 5; ++i) {
    const auto& entry = series[static_cast<std::size_t>(i)];
    EXPECT_EQ(entry.time, test::make_mushroom(2, 0.1 * i, i).time);
    EXPECT_EQ(frame_number(entry.file), i);
    EXPECT_EQ(read_frame(entry.file).time, entry.time);
  }
}

TEST_F(ParticleSeries, ContinuesAfterARestart) {
  write_frames(0, 6);
  write_frames(3, 5);  // goes back to frame 3, and is killed before it reaches frame 5
  const auto series = read_series(folder_);
  ASSERT_EQ(series.size(), 5U);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(frame_number(series[static_cast<std::size_t>(i)].file), i);
  EXPECT_FALSE(fs::exists(folder_ / "frames" / "mushroom_000005.vtp"));
}

TEST_F(ParticleSeries, FindsFramesThatTheSeriesFileMissed) {
  write_frames(0, 3);
  fs::remove(folder_ / "mushroom.pvd");  // as after a kill between a frame and its entry
  write_frames(3, 4);
  EXPECT_EQ(read_series(folder_).size(), 4U);
}

TEST_F(ParticleSeries, WritesNoTimeTwice) {
  ParticleSeriesWriter writer(folder_, "mushroom", {});
  writer.write(test::make_mushroom(2, 0.1, 0));
  writer.write(test::make_mushroom(2, 0.2, 1));
  writer.write(test::make_mushroom(2, 0.2, 2));
  const auto series = read_series(folder_);
  ASSERT_EQ(series.size(), 2U);
  EXPECT_LT(series[0].time, series[1].time);
}

TEST_F(ParticleSeries, CanBeMovedAsAWhole) {
  write_frames(0, 2);
  const fs::path moved = folder_ / "elsewhere";
  fs::create_directory(moved);
  fs::rename(folder_ / "frames", moved / "frames");
  fs::rename(folder_ / "mushroom.pvd", moved / "mushroom.pvd");
  for (const auto& entry : read_series(moved)) EXPECT_EQ(read_frame(entry.file).particle_count(), 40U);
}

TEST_F(ParticleSeries, LeavesNoTemporaryFiles) {
  write_frames(0, 2);
  for (const auto& item : fs::recursive_directory_iterator(folder_))
    EXPECT_TRUE(item.is_directory() || item.path().extension() == ".vtp" || item.path().extension() == ".pvd");
}

TEST_F(ParticleSeries, RefusesUnknownFormats) {
  EXPECT_THROW(ParticleSeriesWriter(folder_, "mushroom", {"vtk", "float32", "lz4"}), InputError);
  EXPECT_THROW(ParticleSeriesWriter(folder_, "mushroom", {"vtp", "float16", "lz4"}), InputError);
  EXPECT_THROW(ParticleSeriesWriter(folder_, "mushroom", {"vtp", "float32", "gzip"}), InputError);
}

/// While it lives, no file can grow beyond `bytes`: the system refuses as it does on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : signal_before_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_before_);
  }

 private:
  rlimit before_{};
  void (*signal_before_)(int);
};

TEST_F(ParticleSeries, NamesTheFileAndTheReasonWhenItDoesNotFit) {
  ParticleSeriesWriter writer(folder_, "mushroom", {});
  writer.write(test::make_mushroom(2, 0.1, 0));
  const auto size = fs::file_size(read_series(folder_)[0].file);
  // At the start, in the middle, and only with the last block that is held back until the file is closed.
  for (const rlim_t limit : {rlim_t{1}, static_cast<rlim_t>(size / 2), static_cast<rlim_t>(size - 5)}) {
    try {
      const FileSizeLimit full(limit);
      writer.write(test::make_mushroom(2, 0.2, 1));
      ADD_FAILURE() << "a file cut off at " << limit << " bytes went unnoticed";
    } catch (const MissingResourceError& error) {
      EXPECT_NE(std::string(error.what()).find("mushroom_000001.vtp': File too large"), std::string::npos)
          << error.what();
    }
    EXPECT_EQ(read_series(folder_).size(), 1U);
    EXPECT_FALSE(fs::exists(folder_ / "frames" / "mushroom_000001.vtp"));
  }
}

TEST_F(ParticleSeries, NamesTheFolderThatCannotBeMade) {
  write_text_atomically(folder_ / "file", "not a folder");
  EXPECT_THROW(ParticleSeriesWriter(folder_ / "file" / "result", "mushroom", {}), MissingResourceError);
}

TEST_F(ParticleSeries, RefusesTornFilesWhereverTheyEnd) {
  write_frames(0, 1, {"vtp", "float32", "none"});
  const fs::path file = folder_ / "frames" / "mushroom_000000.vtp";
  const std::string whole = read_text(file);
  for (std::size_t length = 0; length + 10 < whole.size(); length += whole.size() / 25) {
    std::ofstream(file, std::ios::binary) << whole.substr(0, length);
    EXPECT_THROW(read_frame(file), InputError) << length << " of " << whole.size() << " bytes";
  }
}

TEST_F(ParticleSeries, RefusesWhatIsNoResult) {
  EXPECT_THROW(read_series(folder_ / "nowhere"), InputError);
  EXPECT_THROW(read_series(folder_), InputError);  // an empty folder
  write_text_atomically(folder_ / "a.pvd", "<VTKFile><Collection><DataSet timestep=\"0\" fi");
  EXPECT_THROW(read_series(folder_), InputError);
  write_text_atomically(folder_ / "a.pvd",
                        "<VTKFile><Collection><DataSet timestep=\"soon\" file=\"b\"/></Collection></VTKFile>");
  EXPECT_THROW(read_series(folder_), InputError);
  write_text_atomically(folder_ / "a.pvd", "<VTKFile><Collection/></VTKFile>");
  EXPECT_THROW(read_series(folder_), InputError);
  EXPECT_THROW(read_frame(folder_ / "a.pvd"), InputError);
  write_text_atomically(folder_ / "b.pvd", "");
  EXPECT_THROW(read_series(folder_), InputError);  // two to choose from
}

TEST_F(ParticleSeries, NamesAFrameThatIsListedButMissing) {
  write_frames(0, 2);
  fs::remove(folder_ / "frames" / "mushroom_000001.vtp");
  EXPECT_THROW(read_frame(read_series(folder_)[1].file), InputError);
}

}  // namespace
}  // namespace anvil
