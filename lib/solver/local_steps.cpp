// SPDX-License-Identifier: BSD-3-Clause
// A long step of a total Lagrangian scene in which the squeezed parts take several shorter ones. The parts are those of
// a plain step, in its order: impulses, boundaries and drift, strain.
#include "anvil/solver/local_steps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "anvil/solver/tiles.hpp"

namespace anvil {
namespace {

constexpr int highest_level = 5;  // 32 shortest steps

/// Whether a step of this level begins with the part, or ends before it.
bool meets(int part, int level) { return part % (1 << level) == 0; }

}  // namespace

auto LocalSteps::around(const Tiles& tiles) const -> Tiles {
  Tiles found(&memory);
  for (const std::int32_t tile : tiles) {
    const Tiles& nearby = near[static_cast<std::size_t>(tile)];
    found.insert(found.end(), nearby.begin(), nearby.end());
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void LocalSteps::least_around(const std::vector<int>& level, std::vector<int>& least) const {
  least = level;
  for (std::size_t t = 0; t < level.size(); ++t)
    for (const std::int32_t beside : near[t]) least[t] = std::min(least[t], level[static_cast<std::size_t>(beside)]);
}

void LocalSteps::classify(double shortest, int greatest) {
  allowed_.clear();
  for (const double own : limit) {
    int allowed = 0;
    while (allowed < greatest && shortest * (2 << allowed) <= own) ++allowed;
    allowed_.push_back(allowed);
  }
  least_around(allowed_, edge_level);
  least_around(edge_level, strain_level);
  least_around(strain_level, move_level);
  highest = *std::max_element(edge_level.begin(), edge_level.end());
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
  steps.start.assign(highest_level + 1, std::vector<double>(particle_count() * D));
}

template <int D>
void Solver<D>::advance_locally(double latest) {
  LocalSteps& steps = *local_steps_;
  steps.limit.clear();
  for (const auto& report : reports_) steps.limit.push_back(report.step_limit);
  const double left = latest - time_;
  int level = highest_level;
  while (level > 0 && left < step_limit_ * (1 << level)) --level;
  steps.classify(step_limit_, level);
  level = steps.highest;
  // The last two steps before `latest` are equal, so that none is a mere splinter.
  double long_step = step_limit_ * (1 << level);
  if (left <= long_step)
    long_step = left;
  else if (left < 2.0 * long_step)
    long_step = 0.5 * left;
  const int parts = 1 << level;
  for (int part = 0; part < parts; ++part) {
    give_impulses(part, long_step / parts);
    move_locally(part, long_step / parts);
    strain_locally(part, long_step / parts);
  }
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

/// The impulse of a stress is that over half its last step and half its next one, at the beginning of that.
template <int D>
void Solver<D>::give_impulses(int part, double shortest) {
  LocalSteps& steps = *local_steps_;
  // Stresses that act now, and those whose impulses of the part before must go.
  const auto changed = [&](const std::vector<int>& level) {
    return steps.where([&](std::size_t t) { return meets(part, level[t]) || (part > 0 && meets(part - 1, level[t])); });
  };
  const auto span_of = [&](std::size_t t, const std::vector<int>& level, std::vector<double>& last) {
    if (!meets(part, level[t])) return 0.0;
    const double next = shortest * (1 << level[t]), span = 0.5 * (last[t] + next);
    last[t] = next;
    return span;
  };
  LocalSteps::Tiles packed = changed(steps.strain_level);
  if (recipe_.edges) {
    const LocalSteps::Tiles weighed = changed(steps.edge_level);
    for_each_tile_of(weighed, [&](const Tile& tile, Scratch&, TileReport<D>&) {
      const std::size_t t = tile_index(tile);
      recipe_.edges->weigh(recipe_.edges->edges_from(tile.range), span_of(t, steps.edge_level, steps.edge_step));
    });
    packed.insert(packed.end(), weighed.begin(), weighed.end());
    packed = steps.around(packed);
  }
  for_each_tile_of(packed, [&](const Tile& tile, Scratch&, TileReport<D>&) {
    const std::size_t t = tile_index(tile);
    recipe_.nominal_momentum->pack_impulses(tile.range, span_of(t, steps.strain_level, steps.particle_step), records_);
  });
  fill_image_states();
  const auto pushed = steps.where([&](std::size_t t) { return meets(part, steps.move_level[t]); });
  for_each_tile_of(pushed, [&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    accelerate_tile(tile, scratch, 1.0, report);  // sums over impulses are changes of velocity
  });
  if (!recipe_.images.reflect()) return;
  Vec<D> impulse = Vec<D>::Zero();
  for (const std::int32_t tile : pushed) impulse += reports_[static_cast<std::size_t>(tile)].force_impulse;
  ledger_.wall_impulse += recipe_.images.push_directions() * impulse;
}

template <int D>
void Solver<D>::move_locally(int part, double shortest) {
  LocalSteps& steps = *local_steps_;
  const auto moved = steps.where([&](std::size_t t) { return meets(part, steps.move_level[t]); });
  for_each_tile_of(moved, [&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    const int own = steps.move_level[tile_index(tile)];
    for (int level = own + 1; level <= steps.highest && meets(part, level); ++level)
      std::copy_n(position_.raw() + tile.range.first() * D, tile.range.count() * D,
                  &steps.start[static_cast<std::size_t>(level)][tile.range.first() * D]);
    const double time_step = shortest * (1 << own);
    apply_boundaries(tile, scratch, time_step, report);
    move_tile(tile, time_step, report);
    pack_motion(tile.range);
  });
  for (const std::int32_t tile : moved) {
    const auto& report = reports_[static_cast<std::size_t>(tile)];
    ledger_.wall_impulse += report.wall_impulse;
    ledger_.wall_loss += report.wall_loss;
  }
  check_reports();
}

/// Strains what ends a step with the part, from short steps to long ones. Particles of shorter steps than those they
/// strain show their mean velocity meanwhile.
template <int D>
void Solver<D>::strain_locally(int part, double shortest) {
  const LocalSteps& steps = *local_steps_;
  LocalSteps::Tiles shown(&steps.memory);
  for (int level = 0; level <= steps.highest && meets(part + 1, level); ++level) {
    const double time_step = shortest * (1 << level);
    const auto strained = steps.where([&](std::size_t t) { return steps.strain_level[t] == level; });
    const auto edges = steps.where([&](std::size_t t) { return steps.edge_level[t] == level; });
    if (strained.empty() && edges.empty()) continue;
    const auto averaged =
        steps.those_of(steps.around(strained), [&](std::size_t t) { return steps.move_level[t] < level; });
    shown.insert(shown.end(), averaged.begin(), averaged.end());
    const auto& start = steps.start[static_cast<std::size_t>(level)];
    for_each_tile_of(averaged, [&](const Tile& tile, Scratch&, TileReport<D>&) {
      for (std::size_t i = tile.range.first(); i < tile.range.last(); ++i)
        for (int a = 0; a < D; ++a)
          records_.motion[i][a] = (position_[i][a] - start[i * D + static_cast<std::size_t>(a)]) / time_step;
    });
    strain_tiles(strained, edges, time_step);
  }
  std::sort(shown.begin(), shown.end());
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  for_each_tile_of(shown, [&](const Tile& tile, Scratch&, TileReport<D>&) { pack_motion(tile.range); });
}

template <int D>
void Solver<D>::strain_tiles(std::span<const std::int32_t> particles, std::span<const std::int32_t> edges,
                             double time_step) {
  recipe_.images.fill_motion(records_, records_.first_image());
  for_each_tile_of(particles, [&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    deform_from_reference(tile, scratch, time_step, report);
  });
  for (const std::int32_t tile : particles) {
    auto& report = reports_[static_cast<std::size_t>(tile)];
    ledger_.viscous_loss += report.bulk_viscous_loss;
    ledger_.plastic_work += report.plastic_work;
    ledger_.erosion_loss += std::exchange(report.erosion_loss, 0.0);
  }
  if (!recipe_.edges) return;
  for_each_tile_of(edges, [&](const Tile& tile, Scratch& scratch, TileReport<D>& report) {
    deform_edges(tile, scratch, time_step, report);
  });
  for (const std::int32_t tile : edges) {
    ledger_.plastic_work += reports_[static_cast<std::size_t>(tile)].plastic_work;
    ledger_.erosion_loss += std::exchange(reports_[static_cast<std::size_t>(tile)].erosion_loss, 0.0);
  }
}

#define ANVIL_INSTANTIATE(D)                  \
  template void Solver<D>::find_near_tiles(); \
  template void Solver<D>::advance_locally(double)
ANVIL_INSTANTIATE(1);
ANVIL_INSTANTIATE(2);
ANVIL_INSTANTIATE(3);
#undef ANVIL_INSTANTIATE

}  // namespace anvil
