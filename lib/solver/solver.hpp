// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "anvil/pairs/neighbour_list.hpp"
#include "anvil/solver/local_steps.hpp"
#include "anvil/solver/recipe.hpp"
#include "anvil/solver/simulation.hpp"

namespace anvil {

/// What one tile did in one pass; added up in the order of the tiles, so that sums do not depend on threads.
template <int D>
struct TileReport {
  double plastic_work = 0.0;                               // J
  double viscous_loss = 0.0;                               // J
  double bulk_viscous_loss = 0.0;                          // J
  double erosion_loss = 0.0;                               // J, not yet in the ledger
  double smoothing_loss = 0.0;                             // J
  Vec<D> smoothing_impulse = Vec<D>::Zero();               // N s
  double wall_loss = 0.0;                                  // J
  int uncorrected = 0;                                     // particles without a corrected gradient
  Vec<D> wall_impulse = Vec<D>::Zero();                    // N s, on the particles
  Vec<D> force_impulse = Vec<D>::Zero();                   // N s, of all sums over pairs; only with images
  double gravity_work = 0.0;                               // J
  double diffusion_loss = 0.0;                             // J
  Vec<D> least_displacement, greatest_displacement;        // m, since the neighbour list was made
  double greatest_growth = 0.0;                            // m, of smoothing lengths since then
  double step_limit = std::numeric_limits<double>::max();  // s
  std::int32_t limiting_particle = -1;
  std::int32_t inverted_edge_at = -1;  // a particle of a total Lagrangian body
  std::int32_t broken_particle = -1;   // the first whose numbers are no longer any, or that went where none may
};

/// The same for a tile of dummy particles.
template <int D>
struct WallReport {
  Vec<D> impulse = Vec<D>::Zero();  // N s, on the wall
  double stress_work = 0.0;         // J, of the stress of the wall on what strains beside it
  double motion_work = 0.0;         // J, of the force on the wall along its velocity
  double viscous_loss = 0.0;        // J
};

/// What left the bodies or changed its kind since the start.
template <int D>
struct Ledger {
  double plastic_work = 0.0;                  // J
  double viscous_loss = 0.0;                  // J
  double smoothing_loss = 0.0;                // J
  double wall_loss = 0.0;                     // J
  double contact_loss = 0.0;                  // J
  double erosion_loss = 0.0;                  // J
  double contact_impulse = 0.0;               // N s, of all pushes between bodies
  Vec<D> smoothing_impulse = Vec<D>::Zero();  // N s
  Vec<D> wall_impulse = Vec<D>::Zero();       // N s
  Vec<D> pressure_impulse = Vec<D>::Zero();   // N s
  Vec<D> gravity_impulse = Vec<D>::Zero();    // N s
  double pressure_work = 0.0;                 // J, done on the bodies
  double uncorrected = 0.0;                   // sum over the steps of the particles that kept plain gradients
  double gravity_work = 0.0;                  // J, done on the bodies
  double wall_work = 0.0;                     // J, done on the bodies by walls of dummy particles
  double penetrations = 0.0;                  // particles that went through such a wall
  double start_energy = 0.0;                  // J
  Vec<D> start_momentum = Vec<D>::Zero();     // N s
};

/// A scene of D dimensions in motion. Between steps the positions, densities and stresses belong to time(), the
/// velocities to half a step before it.
template <int D>
class Solver final : public Simulation {
 public:
  explicit Solver(const Scene& scene);

  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] double last_time_step() const override { return time_step_; }
  [[nodiscard]] std::int64_t step() const override { return step_; }
  [[nodiscard]] std::size_t particle_count() const override { return fields_.particle_count(); }
  void advance(double latest) override;
  [[nodiscard]] Frame frame() const override;
  [[nodiscard]] std::vector<AuditValue> audit() const override;
  [[nodiscard]] Explanation explain() const override;
  [[nodiscard]] State state() const override;
  void restore(const State& state) override;

 private:
  struct Tile {
    ParticleRange range;
    int body;
  };
  struct Scratch {  // of one thread
    std::vector<double> gradient[D], plain_gradient[D], value;
    std::vector<double> per_particle;    // velocity gradients, accelerations or changes of the tile
    std::vector<double> per_edge;        // velocity gradients
    std::vector<double> density_before;  // of the points of the tile, kg/m3; only with erosion
    std::vector<double> loss, sound_speed, step_limit, lateral_rate;
  };

  // step.cpp and strain.cpp, in the order of a step
  double choose_time_step(double latest) const;
  void accelerate(double kick);
  void load_faces(double kick);
  void kick_loaded_faces();
  void account_loads();
  void account_mirror_planes();
  void account_gravity(const Tile& tile, TileReport<D>& report);
  bool is_held(const Tile& tile) const;
  void stop_straining_held(const Tile& tile, double* velocity_gradient) const;
  void filter_velocities(double time_step);
  void transport_velocities();
  void move(double time_step);
  void refresh_neighbours();
  void strain(double time_step);
  void transport_strains(double time_step);

  void strain_from_reference(double time_step);  // total_lagrangian_step.cpp
  void deform_from_reference(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report);
  void deform_edges(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report);
  void limit_and_check_deformed(const Tile& tile, const Scratch& scratch, TileReport<D>& report);
  void collect_strain_reports();

  void erode_particles(const Tile& tile, Scratch& scratch, TileReport<D>& report);  // erosion.cpp
  void erode_edges(const Tile& tile, Scratch& scratch, TileReport<D>& report);
  double eroded_mass(const FieldStore& points) const;

  void find_near_tiles();  // local_steps.cpp
  void advance_locally(double latest);
  void give_impulses(int part, double shortest);
  void move_locally(int part, double shortest);
  void strain_locally(int part, double shortest);
  void strain_tiles(std::span<const std::int32_t> particles, std::span<const std::int32_t> edges, double time_step);

  void accelerate_tile(const Tile& tile, Scratch& scratch, double kick, TileReport<D>& report);
  void filter_tile(const Tile& tile, const VelocityFilter<D>& filter, Scratch& scratch, double time_step,
                   TileReport<D>& report);
  void move_tile(const Tile& tile, double time_step, TileReport<D>& report);
  void note_displacements(const Tile& tile, TileReport<D>& report) const;
  void apply_boundaries(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report);
  void strain_tile(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report);
  void find_velocity_gradients(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report);
  void deform_tile(const Tile& tile, const double* velocity_gradient, Scratch& scratch, double time_step,
                   TileReport<D>& report);
  void respond_tile(const Tile& tile, Scratch& scratch, double time_step, TileReport<D>& report);
  void diffuse_density(const Tile& tile, const PairTile<D>& pairs, Scratch& scratch, double time_step,
                       TileReport<D>& report);
  void exchange_energy(const Tile& tile, const Scratch& scratch, double kick);
  void charge_pairs(std::size_t i, const Vec<D>& pair_change, const Vec<D>& change);
  void update_density(ParticleRange range, const double* velocity_gradient, const double* lateral_rate,
                      double time_step);
  void pack_limit_and_check(const Tile& tile, Scratch& scratch, TileReport<D>& report);
  void find_step_limits(const Tile& tile, Scratch& scratch) const;

  // solver.cpp and tiles.hpp
  template <class Work>
  void for_each_tile(Work&& work);
  template <class Work>
  void for_each_tile_of(std::span<const std::int32_t> tiles, Work&& work);
  [[nodiscard]] std::size_t tile_index(const Tile& tile) const {
    return static_cast<std::size_t>(&tile - tiles_.data());
  }
  PairTile<D> open_tile(const Tile& tile, Scratch& scratch, PairNeeds needs) const;
  void make_tiles();
  void size_scratch();
  void pack_geometry(ParticleRange range);
  void pack_motion(ParticleRange range);
  void pack_sizes(ParticleRange range);
  void pack_velocities(ParticleRange range);
  void list_neighbours();
  void freeze_pairs();
  void pack_start(ParticleRange range);
  void wrap_positions();
  void find_images();
  void fill_image_places();
  void fill_image_states();

  // walls.cpp
  [[nodiscard]] std::size_t bodies_end() const { return ranges_.back().last(); }  // where dummy particles begin
  template <class Work>
  void for_each_wall_tile(Work&& work);
  template <class Take>
  void for_each_beside(const PairTile<D>& pairs, std::size_t dummy, Take&& take) const;
  void make_wall_tiles();
  void list_walls();
  void weigh_walls(bool shown);
  void move_walls(double time_step);
  void load_walls(double kick);
  void interpolate(const PairTile<D>& pairs, const DummyRows<D>& wall, std::size_t dummy);
  double stress_power(std::size_t particle, const double* gradient) const;
  void count_penetrations(double time_step);
  void find_corrections();

  // guards.cpp
  void check_reports() const;
  [[noreturn]] void stop_at(std::int32_t particle, const std::string& reason) const;

  // audit.cpp
  double kinetic_energy() const;
  double elastic_energy() const;
  double energy_stored_by_walls() const;
  double internal_energy() const;
  double stored_energy() const;
  Vec<D> momentum() const;
  double minimum_pair_distance() const;

  // explain.cpp
  std::int64_t count_pairs() const;

  Scene scene_;
  std::vector<ParticleRange> ranges_;  // of the bodies
  Walls<D> walls_;
  FieldStore fields_;
  Recipe<D> recipe_;
  const PairLoops<D>& loops_;
  typename PairLoops<D>::KernelLoops kernel_loops_;
  NeighbourList<D> neighbours_;
  std::vector<double> frozen_gradient_[D];  // of all pairs, in total Lagrangian scenes
  PairRecords<D> records_;
  std::vector<Tile> tiles_;
  std::vector<TileReport<D>> reports_;
  std::vector<Tile> wall_tiles_;  // whose `body` is the number of the wall
  std::vector<WallReport<D>> wall_reports_;
  std::vector<double> wall_weight_;  // of dummy particles in momentum sums
  double* wall_deviator_ = nullptr;  // of all particles, packed; null in a fluid
  std::optional<LocalSteps> local_steps_;
  std::vector<Scratch> scratch_;
  bool medium_needed_ = false;
  bool smoothing_length_varies_ = true;
  bool velocities_filtered_ = false;

  VectorView<D> position_, initial_position_, velocity_, listed_position_;
  VectorView<D> start_velocity_;  // only where velocities are filtered
  std::span<double> mass_, density_, smoothing_length_, pressure_;
  std::span<double> listed_smoothing_length_;  // empty while h is constant
  // Where an equation of state reads the energy or pairs exchange it; the latter keep it at the time of the velocities.
  std::span<double> specific_energy_, kick_energy_;
  std::span<double> correction_;  // of gradients, where a term reads those of both sides

  struct LoadStep {                // of one load in the present step
    double impulse = 0.0;          // N s, towards the body
    double velocity_before = 0.0;  // m/s, of its particle
  };
  std::vector<LoadStep> load_steps_;
  std::vector<double> face_stress_;  // Pa, by load: the mean over the kick
  std::vector<double> strain_rate_;  // 1/s, along the line; only where strains are filtered

  double skin_ = 0.0;  // m
  double kick_ = 0.0;  // s, of the present step
  double time_ = 0.0, time_step_ = 0.0, step_limit_ = 0.0, first_step_limit_ = 0.0;
  std::int32_t limiting_particle_ = -1;
  std::int64_t step_ = 0, list_builds_ = 0;
  Ledger<D> ledger_;
};

}  // namespace anvil
