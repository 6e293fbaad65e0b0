// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "unit/output/temporary_folder.hpp"

namespace anvil {
namespace {

std::vector<Quantity> row(double time, double impulse) {
  return {{"time", "s", time}, {"step", "", std::round(time * 10.0)}, {"wall_impulse_z", "N s", impulse}};
}

TEST(History, StartsWithNamesAndUnits) {
  const TemporaryFolder folder;
  HistoryWriter(folder / "history.csv").append(row(0.5, 2.0));
  EXPECT_EQ(read_text(folder / "history.csv"), "time [s],step,wall_impulse_z [N s]\n0.5,5,2\n");
}

TEST(History, KeepsEveryBit) {
  const TemporaryFolder folder;
  const std::vector<double> numbers = {0.1, 1.0 / 3.0, -0.0, 5e-324, 1.7976931348623157e308, 123456789012345678.0};
  {
    HistoryWriter writer(folder / "history.csv");
    for (const double number : numbers) writer.append(row(0.0, number));
  }
  const History history = read_history(folder / "history.csv");
  ASSERT_NE(history.find("wall_impulse_z"), nullptr);
  const auto& column = *history.find("wall_impulse_z");
  EXPECT_EQ(column.unit, "N s");
  ASSERT_EQ(column.values.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(column.values[i], numbers[i]);
    EXPECT_EQ(std::signbit(column.values[i]), std::signbit(numbers[i]));
  }
}

TEST(History, CarriesNumbersThatAreNone) {
  const TemporaryFolder folder;
  HistoryWriter(folder / "history.csv").append(row(0.0, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(std::isnan(read_history(folder / "history.csv").find("wall_impulse_z")->values.front()));
}

TEST(History, IsReadableWhileTheRunGoesOn) {
  const TemporaryFolder folder;
  HistoryWriter writer(folder / "history.csv");
  writer.append(row(0.0, 1.0));
  EXPECT_EQ(read_history(folder / "history.csv").rows(), 1U);
  writer.append(row(1.0, 2.0));
  EXPECT_EQ(read_history(folder / "history.csv").rows(), 2U);
}

TEST(History, LeavesOutATornLastRow) {
  const TemporaryFolder folder;
  write_file(folder / "history.csv", "time [s],step\n0,0\n1,1\n2,");
  EXPECT_EQ(read_history(folder / "history.csv").rows(), 2U);
}

TEST(History, GoesOnAfterTheRowsOfTheCheckpoint) {
  const TemporaryFolder folder;
  {
    HistoryWriter writer(folder / "history.csv");
    for (int i = 0; i < 5; ++i) writer.append(row(i, i));
  }
  const std::string undisturbed = read_text(folder / "history.csv");
  {
    HistoryWriter writer(folder / "history.csv", 3);
    EXPECT_EQ(writer.rows(), 3);
    for (int i = 3; i < 5; ++i) writer.append(row(i, i));
  }
  EXPECT_EQ(read_text(folder / "history.csv"), undisturbed);
}

TEST(History, RefusesToGoOnWithTooFewRowsOrOtherColumns) {
  const TemporaryFolder folder;
  HistoryWriter(folder / "history.csv").append(row(0.0, 1.0));
  EXPECT_THROW(HistoryWriter(folder / "history.csv", 2), InputError);
  HistoryWriter writer(folder / "history.csv", 1);
  EXPECT_THROW(writer.append({{"time", "s", 1.0}}), InputError);
}

TEST(History, NamesTheLineThatIsDamaged) {
  const TemporaryFolder folder;
  for (const char* text : {"time [s],step\n0,0\n1\n", "time [s],step\n0,0\n1,one\n"}) {
    write_file(folder / "history.csv", text);
    try {
      read_history(folder / "history.csv");
      FAIL() << "read a damaged file";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("history.csv:3:"), std::string::npos) << error.what();
    }
  }
}

TEST(History, SaysThatTheDiskIsFull) {
  HistoryWriter writer("/dev/full");
  try {
    writer.append(row(0.0, 1.0));
    FAIL() << "wrote to a full device";
  } catch (const MissingResourceError& error) {
    EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace anvil
