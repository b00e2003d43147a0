// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chaindrive/contact/joint_flexibility.h>
#include <chaindrive/contact/joint_kernels.h>
#include <chaindrive/contact/search_cadence.h>
#include <chaindrive/contact/strip_problem.h>
#include <chaindrive/mesh/surface/cylinder_grid.h>
#include <chaindrive/utilities/archive.h>
#include <chaindrive/utilities/complementarity.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace chaindrive::contact
{
/// Tables of the joints of one kind, such as all roller bores on bushes: JointGrid and its arrays.
class JointTables
{
public:
  /// @p master is the bore's side, @p slave that of the cylinder inside it. Throws InputError if
  /// the columns of either are not equally far apart.
  JointTables(const mesh::CylinderGrid &master, const mesh::CylinderGrid &slave);

  JointGrid    grid() const;
  unsigned int n_slave_nodes() const { return grid_.slave_circumferential * grid_.slave_rings; }

private:
  JointGrid           grid_;
  std::vector<double> area_, inside_, cover_;
};

/// Offsets [ring][column] of the nodes of a side in the state of a batch of bodies, for
/// JointArguments. @p vertex_of_node is element::Hexahedra::vertex. Throws std::logic_error if a
/// vertex of the side is no node.
std::vector<unsigned int> node_offsets(const mesh::CylinderGrid        &grid,
                                       const std::vector<unsigned int> &vertex_of_node);

/// One body's share in a joint: pointers to its lane inside its batch, and node_offsets() of its
/// side. All must outlive the joint.
struct JointBody
{
  const unsigned int *node     = nullptr;
  const double       *position = nullptr;
  const double       *velocity = nullptr;
  double             *force    = nullptr;
  char               *pressed  = nullptr; ///< BodyBatches::pressed() of its batch, if it wants them
};

/// Numbers of WindowNodes that joints without penalty need while forces are added, and no longer.
struct JointRoom
{
  dealii::AlignedVector<double> gaps, forces;
  dealii::AlignedVector<char>   met;
};

/// Up to n_lanes joints of one kind: search -> geometry -> law for the nodes of their sides.
///
/// The search lists per joint the slave columns that have come closer to the bore than a reach. It
/// holds until a gap may have become smaller by that reach.
class JointBatch
{
public:
  /// @p tables must outlive the batch. @p kernels are those of joint_kernels().
  JointBatch(const JointTables &tables, const scene::ContactLaw &law, const JointKernels &kernels);

  /// From now on normal forces are those that a @p flexibility, which must outlive the batch, asks
  /// for in place of a penalty: gaps that have no force, and forces that leave no gap. Batches that
  /// share a @p room do not push each other's numbers out of the cache; null: one of its own.
  void set_flexibility(const JointFlexibility    &flexibility,
                       std::shared_ptr<JointRoom> room = nullptr);

  /// Of joints without penalty whose bores are those of rollers: until the next call the forces of
  /// these @p strips on the outside of the one in @p lane, which deflect its bore through a @p wall
  /// and are deflected by it, are found with those of the joint, whose first slave column is at
  /// @p angle [rad] in the world. Null, or none: no strips. Both must outlive that.
  void couple(int lane, StripProblem *strips, const WallFlexibility *wall, double angle);

  void set_joint(int lane, const JointBody &master, const JointBody &slave);

  /// From now on searches look by so much [m] farther in @p lane: for what forces deflect there
  /// beside where bodies and modes have moved surfaces.
  void   set_deflection(int lane, double deflection) { deflection_[lane] = deflection; }
  double deflection(int lane) const { return deflection_[lane]; }

  /// By how much [m] at most what is pressed together in @p lane, without penalty, was deflected
  /// when forces were last added.
  double deflected(int lane) const { return deflected_[lane]; }

  /// Makes the windows anew, of what is nearer than a @p reach [m], not negative, and a @p margin
  /// [m]. It holds until surfaces may have come nearer by the reach, with 0 for no step: with @p
  /// unforeseen [m/s], positive, for a time, see holding_time(); without it for this distance.
  /// Returns how many slave nodes overlap that the windows before have let alone, if forces were
  /// added with them later than at once: there must be none.
  unsigned int search(double reach, std::optional<double> unforeseen, double margin = 0.);

  /// Of a search by distance: it measures those columns alone that may have come nearer than what
  /// it looks for since they have been measured. Others are known to be farther away. To be called
  /// before the search() with the same @p reach and @p margin, and the @p use that add_forces() is
  /// going to have; without it that measures all of them.
  void choose_columns(double reach, double margin, double use);

  /// Whether search() must come before the next add_forces() with @p use.
  bool search_due(double use) const { return cadence_.is_due(use); }

  /// Of the last search, if by distance: how far it looked in @p lane, m; 0 before there was one.
  double reach(int lane) const { return reach_[lane]; }

  /// After a search by distance: it holds for @p stock [m], the next add_forces() included. Steps
  /// forth and back have been counted twice, and surfaces are not as much nearer as has been used.
  void renew(double stock) { cadence_.extend(stock); }

  /// Adds the contact forces to both sides of each joint. @p dt is the time since the last call
  /// [s], 0 at the first one; @p use what the search has held for since then, time or distance.
  void add_forces(double dt, double use);

  /// What the joint in @p lane remembers. Joints that come from several batches hold as long as the
  /// first of these would have held; lanes are to be read in ascending order.
  void serialize(int lane, const Archive &archive);

  /// Gaps of all slave nodes [slave node][lane], m, measured now; see GapArguments.
  const dealii::AlignedVector<double> &measure_gaps();

  /// Marks the columns of a side of @p lane that add_forces() reads until the next search: of the
  /// cylinder those in its window, of the bore those that they may meet, with one more on either
  /// side, since nothing slides by a column while a search holds. To be called after search(), at
  /// any time.
  void mark_circumferential(int lane, bool of_slave, std::vector<char> &columns) const;

  /// The same for what a search() reads, after choose_columns(). Since a column has been measured
  /// it has slid by less than two of the bore's.
  void mark_wanted(int lane, bool of_slave, std::vector<char> &columns) const;

  const JointGrid &grid() const { return grid_; }

  /// Slave nodes that add_forces() visits in all joints.
  unsigned int n_visited() const;

  const JointSums   &sums() const { return sums_; }
  const JointWindow &window() const { return window_; }

  /// Contact forces of the last call and what the nodes remember, [slave node][TouchEntry][lane].
  const dealii::AlignedVector<double> &state() const { return state_; }

  /// What touches at a node of a cylinder.
  struct TouchingNode
  {
    unsigned int          node;       ///< [ring][column]
    double                normal;     ///< force, N
    double                pressure;   ///< over the part of its area that is inside the bore, Pa
    std::array<double, 2> tangential; ///< on the node round the bore, and along it, N
  };

  /// Calls @p visit with each TouchingNode of the joint in @p lane.
  template <typename Visit>
  void for_each_touching(const unsigned int lane, const Visit &visit) const
  {
    const unsigned int n = grid_.slave_circumferential;
    for (unsigned int s = 0; s < grid_.slave_rings; ++s)
      for (unsigned int i = 0; i < window_.count[lane]; ++i)
        {
          const unsigned int node  = s * n + (window_.first[lane] + i) % n;
          const auto         entry = [&](const TouchEntry e) {
            return state_[(node * n_touch_entries + e) * n_lanes + lane];
          };
          if (const double normal = entry(touch_normal); normal > 0.)
            visit(TouchingNode{node,
                               normal,
                               normal / grid_.inside[s],
                               {{entry(touch_tangential_around), entry(touch_tangential_along)}}});
        }
  }

  void clear_losses(); ///< sets damping and friction losses to zero

  std::size_t memory_consumption() const;

private:
  static constexpr double let_alone = 16e-6; ///< m: by which columns may come nearer unmeasured

  /// By how much surfaces may have come nearer since the last search, by distance, m.
  double used(int lane) const { return reach_[lane] - cadence_.stock(); }

  /// Measures the gaps of columns that are wanted, and if @p closing their fastest approach.
  void measure(bool closing);

  /// Adds to the columns of @p lane that are wanted those that a window of some of them may hold.
  void complete_wanted(int lane);

  /// How far away the columns of @p lane that have been measured are at least.
  void bound_gaps(int lane, double near_gap);

  /// Makes one lane's window anew; returns the nodes missed.
  unsigned int search_lane(int lane, double near_gap);

  /// The contact forces of joints without penalty.
  void press();

  /// The problem of @p lane, whose joint has the @p matrix: alone, or with that of its strips.
  ComplementarityProblem problem_of(int lane, const JointFlexibility::Matrix &matrix);

  /// Where the column at a @p place of the window of @p lane with strips is, in the world, rad.
  double column_angle(int lane, unsigned int place) const;

  /// Takes the forces of strips from the solution of @p lane, whose joint has @p n nodes. Returns
  /// what is stored for these, J.
  double take_strips(int lane, unsigned int n);

  /// Without penalty: the order in which lanes visit the nodes of their windows, those first that
  /// have been nearest to the bore at the last search.
  void order_visits();

  /// Without penalty: how many of these visits come near enough for forces in this step.
  unsigned int n_visits() const;

  /// Makes the set of @p lane those nodes of its window that remember a penetration.
  void recall_touching(int lane);

  /// Points the kernels' arguments to what this holds, wherever that has been moved.
  void connect();

  const JointKernels           &kernels_;
  JointGrid                     grid_;
  JointArguments                arguments_;
  JointWindow                   window_;
  JointSums                     sums_;
  dealii::AlignedVector<double> state_, gap_, covered_;
  std::vector<unsigned int>     ring_, cell_;
  std::vector<unsigned int>     searched_cell_; ///< cell_ at the last search
  std::vector<char>             wanted_;        ///< [column][lane], of the slaves
  std::vector<double>           at_least_;      ///< [column][lane], gaps at the last search, m
  std::array<double, n_lanes>   reach_{};       ///< of the last search, if by distance, m
  std::array<double, n_lanes>   deflection_{};  ///< m
  std::array<double, n_lanes>   deflected_{};   ///< m
  double                        use_ = 0.;      ///< of the forces that are being added
  std::array<double, n_lanes>   closing_{};
  SearchCadence                 cadence_; ///< s

  /// Of joints without penalty.
  struct Exact
  {
    Exact(const JointFlexibility &flexibility, std::shared_ptr<JointRoom> room);

    const JointFlexibility        &flexibility;
    std::shared_ptr<JointRoom>     room;
    ComplementaritySolver          solver;
    std::array<ClosedSet, n_lanes> sets;               ///< of nodes [place in the window][ring]
    bool                           new_windows = true; ///< which the sets do not refer to
    dealii::AlignedVector<char>    known;              ///< of WindowNodes
    std::vector<unsigned int>      order;              ///< see WindowNodes
    std::vector<unsigned int>      visit_of;           ///< [node of the window][lane]
    std::vector<double>            nearest;            ///< [visit]: gap at the search, any lane, m
    std::vector<char>              is_pressed;         ///< visits
    std::vector<unsigned int>      pressed;

    /// Joint and strips of a lane, and the rows of their matrix that close: a few of a hundred.
    struct Coupled : LazyRows
    {
      void need(unsigned int row) override;

      StripProblem                   *strips  = nullptr;
      const WallFlexibility          *wall    = nullptr;
      const JointFlexibility::Matrix *joint   = nullptr;
      double                          angle   = 0.; ///< of the bush
      double                          first   = 0.; ///< of the first column of the window
      double                          column  = 0.; ///< between columns, rad
      unsigned int                    n_rings = 0;  ///< of the joint
      unsigned int                    stride  = 0;
      dealii::AlignedVector<double>   matrix;
      std::vector<char>               is_there; ///< of its rows
      std::vector<double>             of_place; ///< room for a strip and a column

      static constexpr unsigned int no_strip = static_cast<unsigned int>(-1);
      unsigned int                  of_strip = no_strip; ///< whose numbers of_columns has
      std::vector<double>           of_columns;          ///< [column][ring][place]
      std::vector<double>           slopes; ///< room: [column that touches][ring][place]
    };
    std::array<Coupled, n_lanes> coupled;

    std::array<dealii::AlignedVector<double>, n_lanes>    gap;
    std::array<const JointFlexibility::Matrix *, n_lanes> matrix{}; ///< at the last solution
  };
  std::unique_ptr<Exact> exact_;
  bool                   fresh_ = false; ///< searched since the last add_forces()
};
} // namespace chaindrive::contact
