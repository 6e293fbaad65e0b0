// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "anvil/solver/run.hpp"

namespace anvil {

/// Where progress is shown: a share of the whole, the seconds so far, and a text.
class ProgressPainter {
 public:
  ProgressPainter() = default;
  ProgressPainter(const ProgressPainter&) = delete;
  ProgressPainter& operator=(const ProgressPainter&) = delete;
  virtual ~ProgressPainter() = default;
  virtual void paint(double fraction, double wall_seconds, const std::string& text) = 0;
};

/// Of a run: a bar with the time left when standard error is a terminal, a line every 10 % or 5 s otherwise, nothing
/// when `quiet`.
std::unique_ptr<Progress> make_progress(bool quiet);

/// The same for work that is done piece by piece.
class PieceProgress {
 public:
  /// `what` names a piece: "frame".
  PieceProgress(std::string what, std::size_t count, bool quiet);
  void show(std::size_t done);

 private:
  std::string what_;
  std::size_t count_;
  std::unique_ptr<ProgressPainter> painter_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "42 s", "3:07 min", "1:20 h".
std::string duration_text(double seconds);

}  // namespace anvil
