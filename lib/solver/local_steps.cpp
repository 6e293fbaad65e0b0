// SPDX-License-Identifier: BSD-3-Clause
// A long step of a total Lagrangian scene in which the squeezed parts take several short ones. The parts are those of a
// plain step, in its order: impulses, boundaries and drift, strain.
#include "anvil/solver/local_steps.hpp"

#include <algorithm>
#include <cmath>

#include "anvil/solver/tiles.hpp"

namespace anvil {
namespace {

constexpr int greatest_ratio = 16;

LocalSteps::Tiles without(const LocalSteps::Tiles& all, const LocalSteps::Tiles& some) {
  LocalSteps::Tiles rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

}  // namespace

auto LocalSteps::around(const Tiles& tiles) const -> Tiles {
  Tiles found;
  for (const std::int32_t tile : tiles) {
    const Tiles& nearby = near[static_cast<std::size_t>(tile)];
    found.insert(found.end(), nearby.begin(), nearby.end());
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

auto LocalSteps::squeezed(const std::vector<double>& limit, double longest) const -> Tiles {
  Tiles found;
  for (const std::int32_t tile : all)
    if (limit[static_cast<std::size_t>(tile)] < longest) found.push_back(tile);
  return found;
}

void LocalSteps::classify(const std::vector<double>& limit, double longest) {
  edges = around(squeezed(limit, longest));
  strained = around(edges);
  moved = around(strained);
  other_edges = without(all, edges);
  not_strained = without(all, strained);
}

int LocalSteps::best_ratio(const std::vector<double>& limit) const {
  const double shortest = *std::min_element(limit.begin(), limit.end());
  const auto count = static_cast<double>(all.size());
  int best = 1;
  double least_work = count;
  for (int ratio = 2; ratio <= greatest_ratio; ratio *= 2) {
    const Tiles in_short_steps = around(around(around(squeezed(limit, ratio * shortest))));
    const double work = (count + (ratio - 1) * static_cast<double>(in_short_steps.size())) / ratio;
    if (work >= least_work) continue;
    least_work = work;
    best = ratio;
  }
  return best;
}

/// Two tiles are near when a pair joins them, also across planes of symmetry.
template <int D>
void Solver<D>::find_near_tiles() {
  LocalSteps& steps = *local_steps_;
  std::vector<std::int32_t> tile_of(particle_count());
  for (std::size_t t = 0; t < tiles_.size(); ++t) {
    steps.all.push_back(static_cast<std::int32_t>(t));
    std::fill(tile_of.begin() + tiles_[t].range.begin, tile_of.begin() + tiles_[t].range.end,
              static_cast<std::int32_t>(t));
  }
  steps.near.resize(tiles_.size());
  for (std::size_t i = 0; i < particle_count(); ++i) {
    LocalSteps::Tiles& nearby = steps.near[static_cast<std::size_t>(tile_of[i])];
    nearby.push_back(tile_of[i]);
    for (std::int64_t k = neighbours_.row_begin(i); k < neighbours_.row_end(i); ++k) {
      const auto j = static_cast<std::size_t>(neighbours_.neighbours()[k]);
      if (j == particle_count()) continue;  // padding
      nearby.push_back(tile_of[j < particle_count() ? j : recipe_.images.source(j - records_.first_image())]);
    }
  }
  for (LocalSteps::Tiles& nearby : steps.near) {
    std::sort(nearby.begin(), nearby.end());
    nearby.erase(std::unique(nearby.begin(), nearby.end()), nearby.end());
  }
  steps.particle_step.assign(tiles_.size(), 0.0);
  steps.edge_step.assign(tiles_.size(), 0.0);
  steps.start.resize(particle_count() * D);
}

template <int D>
void Solver<D>::advance_locally(double latest) {
  LocalSteps& steps = *local_steps_;
  std::vector<double> limit;
  for (const auto& report : reports_) limit.push_back(report.step_limit);
  const double left = latest - time_, longest = steps.best_ratio(limit) * step_limit_;
  const double long_step = left <= longest ? left : (left < 2.0 * longest ? 0.5 * left : longest);
  const int count = std::max(1, static_cast<int>(std::ceil(long_step / step_limit_ * (1.0 - 1e-12))));
  const double short_step = long_step / count;
  steps.classify(limit, count == 1 ? 0.0 : long_step);
  for (int part = 0; part < count; ++part) {
    give_impulses(part, short_step, long_step);
    move_locally(part, short_step, long_step);
    strain_locally(steps.strained, steps.edges, short_step);
  }
  pack_mean_velocities(long_step);
  strain_locally(steps.not_strained, steps.other_edges, long_step);
  for_each_tile_of(steps.moved, [&](const Tile& tile, Scratch&, TileReport<D>&) { pack_motion(tile.range); });
  step_limit_ = std::numeric_limits<double>::max();
  for (const auto& report : reports_) {
    if (report.step_limit >= step_limit_) continue;
    step_limit_ = report.step_limit;
    limiting_particle_ = report.limiting_particle;
  }
  time_step_ = long_step;
  time_ = long_step < left ? time_ + long_step : latest;
  ++step_;
  check_reports();
}

/// The impulse of a stress is that over half its last step and half its next one. Stresses of long steps act in the
/// first part only.
template <int D>
void Solver<D>::give_impulses(int part, double short_step, double long_step) {
  LocalSteps& steps = *local_steps_;
  const auto set_span = [&](const LocalSteps::Tiles& tiles, std::vector<double>& last, std::vector<double>& span,
                            double next) {
    for (const std::int32_t tile : tiles) {
      const auto t = static_cast<std::size_t>(tile);
      span[t] = 0.5 * (last[t] + next);
      last[t] = next;
    }
  };
  std::vector<double> particle_span(tiles_.size(), 0.0), edge_span(tiles_.size(), 0.0);
  set_span(steps.strained, steps.particle_step, particle_span, short_step);
  set_span(steps.edges, steps.edge_step, edge_span, short_step);
  if (part == 0) {
    set_span(steps.not_strained, steps.particle_step, particle_span, long_step);
    set_span(steps.other_edges, steps.edge_step, edge_span, long_step);
  }
  if (recipe_.edges)
    for_each_tile_of(part < 2 ? steps.all : steps.edges, [&](const Tile& tile, Scratch&, TileReport<D>&) {
      recipe_.edges->weigh(recipe_.edges->edges_from(tile.range), edge_span[tile_index(tile)]);
    });
  for_each_tile_of(part < 2 ? steps.all : steps.moved, [&](const Tile& tile, Scratch&, TileReport<D>&) {
    recipe_.nominal_momentum->pack_impulses(tile.range, particle_span[tile_index(tile)], records_);
  });
  fill_image_states();
  const LocalSteps::Tiles& pushed = part == 0 ? steps.all : steps.moved;
  for_each_tile_of(pushed, [&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    accelerate_tile(tile, scratch, 1.0, report);  // sums over impulses are changes of velocity
  });
  if (!recipe_.images.reflect()) return;
  Vec<D> impulse = Vec<D>::Zero();
  for (const std::int32_t tile : pushed) impulse += reports_[static_cast<std::size_t>(tile)].force_impulse;
  ledger_.wall_impulse += recipe_.images.push_directions() * impulse;
}

template <int D>
void Solver<D>::move_locally(int part, double short_step, double long_step) {
  LocalSteps& steps = *local_steps_;
  const auto drift = [&](const LocalSteps::Tiles& tiles, double time_step) {
    for_each_tile_of(tiles, [&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
      apply_boundaries(tile, scratch, time_step, report);
      move_tile(tile, time_step, report);
      pack_motion(tile.range);
    });
    for (const std::int32_t tile : tiles) {
      const auto& report = reports_[static_cast<std::size_t>(tile)];
      ledger_.wall_impulse += report.wall_impulse;
      ledger_.wall_loss += report.wall_loss;
    }
  };
  if (part == 0) {
    for_each_tile_of(steps.moved, [&](const Tile& tile, Scratch&, TileReport<D>&) {
      std::copy_n(position_.raw() + tile.range.first() * D, tile.range.count() * D,
                  &steps.start[tile.range.first() * D]);
    });
    drift(without(steps.all, steps.moved), long_step);
  }
  drift(steps.moved, short_step);
  check_reports();
}

template <int D>
void Solver<D>::strain_locally(const std::vector<std::int32_t>& particles, const std::vector<std::int32_t>& edges,
                               double time_step) {
  recipe_.images.fill_motion(records_, records_.first_image());
  for_each_tile_of(particles, [&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    deform_from_reference(tile, scratch, time_step, report);
  });
  for (const std::int32_t tile : particles) {
    const auto& report = reports_[static_cast<std::size_t>(tile)];
    ledger_.viscous_loss += report.bulk_viscous_loss;
    ledger_.plastic_work += report.plastic_work;
  }
  if (!recipe_.edges) return;
  for_each_tile_of(edges, [&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    deform_edges(tile, scratch, time_step, report);
  });
  for (const std::int32_t tile : edges) ledger_.plastic_work += reports_[static_cast<std::size_t>(tile)].plastic_work;
}

/// Of the long step, into the motion records: what strains particles with long steps.
template <int D>
void Solver<D>::pack_mean_velocities(double long_step) {
  const LocalSteps& steps = *local_steps_;
  for_each_tile_of(steps.moved, [&](const Tile& tile, Scratch&, TileReport<D>&) {
    for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i)
      for (int a = 0; a < D; ++a)
        records_.motion[i][a] = (position_[i][a] - steps.start[i * D + static_cast<std::size_t>(a)]) / long_step;
  });
}

#define ANVIL_INSTANTIATE(D)                  \
  template void Solver<D>::find_near_tiles(); \
  template void Solver<D>::advance_locally(double)
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
