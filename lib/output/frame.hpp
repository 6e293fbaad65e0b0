// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace anvil {

/// One array of a frame: `values` holds components x particles doubles, particle by particle.
/// Vectors are padded to 3 components, symmetric tensors hold 6 in VTK's order XX YY ZZ XY YZ XZ.
struct FrameArray {
  std::string name;
  std::string unit;  // SI, "" for pure numbers
  int components = 1;
  bool integer = false;  // to be written as int32
  std::vector<double> values;
};

/// The particles at one time, in the order of their particle_id: what every writer of results receives and every reader
/// gives back.
struct Frame {
  std::string scene;
  double time = 0.0;  // s
  std::int64_t step = 0;
  int index = 0;  // number of the frame in its series, from 0
  int dimension = 3;
  std::vector<double> positions;  // 3 x particles, m
  std::vector<FrameArray> arrays;
  std::vector<std::pair<std::string, std::string>> provenance;  // name, text: written beside the arrays

  [[nodiscard]] std::size_t particle_count() const { return positions.size() / 3; }
  [[nodiscard]] const FrameArray* find(const std::string& name) const {
    for (const auto& array : arrays)
      if (array.name == name) return &array;
    return nullptr;
  }
};

/// A frame of a series that has not been read yet.
struct SeriesEntry {
  double time = 0.0;  // s
  std::filesystem::path file;
};

/// Receives the frames of a run, first to last.
class FrameWriter {
 public:
  FrameWriter() = default;
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;
  virtual ~FrameWriter() = default;
  /// After it returns, everything written so far is complete and readable on disk.
  virtual void write(const Frame& frame) = 0;
};

}  // namespace anvil
