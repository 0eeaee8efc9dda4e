// SPDX-License-Identifier: MIT
// The obstacles of a run on its grid [Batty, Bertails, Bridson 2007].
//
// Where they are: their signed distance phi_s at the nodes of the grid, and from it the open fraction of every face,
// Walls::open, and the mean velocity of its solid part, Walls::u_solid. A step takes the obstacles at the time to which
// its particles belong, and their velocity from the difference of the poses at its two ends: fluid moves away from a
// solid by what the solid will have moved. After the particles have moved, the obstacles are placed anew and push out
// what they caught.
//
// In them: liquid goes on into the cells whose centre they hold, so that no air comes between; faces inside take the
// velocity that particles gave them and the change of velocity outside, then u.n = U.n (free slip), or u = U (no slip).
#pragma once

#include "sim/boundary/dragged_motion.h"
#include "sim/boundary/images.h"
#include "sim/boundary/obstacle.h"
#include "sim/fluid/cells.h"
#include "sim/fluid/extrapolate.h"

#include <cstdint>
#include <vector>

namespace flipbook {

template <int Dim, class Real> class Solids {
public:
  /// Throws UserError for more than 65535 obstacles.
  Solids(const Grid<Dim>& grid, std::vector<Obstacle> obstacles, const Domain& domain);

  [[nodiscard]] bool none() const { return obstacles_.empty(); }
  [[nodiscard]] bool moving() const { return moving_; }
  [[nodiscard]] const std::vector<Obstacle>& all() const { return obstacles_; }
  /// An obstacle in the domain: which, and where it stands; several images of one across periodic sides.
  struct Standing {
    std::size_t obstacle;
    Pose pose;
    Point shift;   ///< of the image (m)
    Bounds bounds; ///< in the domain's coordinates
  };
  [[nodiscard]] const std::vector<Standing>& standing() const { return standing_; }

  // === Where they are
  /// Puts the obstacles where they are at time t and finds the open faces. Does nothing for obstacles at rest but once.
  void place(double t, Walls<Dim, Real>& walls, Pool& pool);
  /// Their velocity from the difference of the poses at two times, where they have been placed.
  void give_velocity(double from, double to, Walls<Dim, Real>& walls, Pool& pool);
  /// The longest step from t on in which no solid moves by more than `cells` cells or turns far; at most `dt`. Throws
  /// UserError, naming the obstacle, where no step is short enough.
  [[nodiscard]] double max_dt(double t, double cells, double dt, const Walls<Dim, Real>& walls) const;

  /// From time t on an obstacle moves by `by` (m) within `over` seconds, on top of what it does by itself. One that
  /// stood still has to be placed again.
  void drag(std::size_t obstacle, double t, const Point& by, double over);

  /// Signed distance at the nodes, up to 4 dx exact outside; pads filled.
  [[nodiscard]] const Field<Real>& distance() const { return phi_; }
  /// Signed distance from x to the nearest obstacle.
  [[nodiscard]] double distance(const Vec<Dim, double>& x) const;

  // === The liquid in them
  /// Cells whose centre lies in a solid take the level set of the open cells beside them, where that is lower.
  void extend(const Walls<Dim, Real>& walls, Field<Real>& phi) const;
  /// The cells that are liquid because a cell beside them holds particles (see Surface::voxel).
  [[nodiscard]] std::vector<std::size_t> wet(const Walls<Dim, Real>& walls, const CellOrder<Dim>& order) const;

  // === The velocity in them
  /// To be called before and after the projection.
  void before_projection(const Components<Dim, Real>& u);
  /// Faces inside that have mass get the change of velocity that the projection made outside.
  void carry_change(const Walls<Dim, Real>& walls, const Cells<Dim, Real>& cells, const Components<Dim, Real>& m,
                    Components<Dim, Real>& u, Pool& pool);
  /// u.n = U.n or u = U on the faces inside. Pads of u must be filled.
  void constrain(const Walls<Dim, Real>& walls, Components<Dim, Real>& u, Pool& pool);

  /// Of a node whose distance is negative: which obstacle holds it, how fast it moves there (m/s), and the way out; the
  /// zero vector where the distance has no direction.
  struct Hold {
    std::size_t obstacle;
    Vec<Dim, Real> U, n;
  };
  [[nodiscard]] Hold hold_on_node(const Index<Dim>& node) const;

  // === The particles
  /// Moves particles that are in an obstacle, or nearer to it than a thousandth of a cell, to that distance along the
  /// gradient. Ballistic ones lose what of their velocity relative to it points into it.
  void push_out(const Walls<Dim, Real>& walls, const std::vector<std::uint8_t>& ballistic,
                Particles<Dim, Real>& particles, Pool& pool) const;

private:
  void stand(std::size_t obstacle, double t, const Walls<Dim, Real>& walls);
  void measure(const Standing& s, std::uint16_t number, Field<Real>& phi, std::vector<std::uint16_t>& owner,
               Pool& pool) const;
  void cut_faces(Walls<Dim, Real>& walls, Pool& pool);
  void find_cut_cells(const Walls<Dim, Real>& walls, Pool& pool);
  /// body(face, cell beyond, open fraction) for the open faces of a cell.
  template <class Body> void each_opening(const Walls<Dim, Real>& walls, std::size_t cell, Body&& body) const;
  [[nodiscard]] std::array<double, 1 << (Dim - 1)> corners(std::size_t at, int axis) const;
  /// The nearest of those around a face or cell.
  [[nodiscard]] const Standing& owner_of(std::size_t at, int axis) const;
  [[nodiscard]] Vec<Dim, Real> normal(std::size_t at, int axis) const;
  [[nodiscard]] Point face_centre(const Index<Dim>& i, int axis) const;

  [[nodiscard]] Bounds visible(const Obstacle& o, const Pose& pose, const Walls<Dim, Real>& walls) const;
  [[nodiscard]] double excess(const Obstacle& o, double t, double dt, double way, const Walls<Dim, Real>& walls) const;

  [[nodiscard]] double distance(const Standing& s, const Point& p) const;
  [[nodiscard]] Point velocity(const Standing& s, const Point& p) const;
  [[nodiscard]] std::pair<double, std::size_t> nearest(const Point& p) const;
  [[nodiscard]] Point gradient(const Standing& s, const Point& p) const;
  /// Brings a caught particle out; which obstacle held it, or the number of obstacles for none.
  std::size_t free(const Walls<Dim, Real>& walls, Vec<Dim, Real>& x) const;
  [[nodiscard]] bool leave_along_axis(const Walls<Dim, Real>& walls, Vec<Dim, Real>& x) const;

  Grid<Dim> grid_;
  Domain domain_;
  std::vector<Obstacle> obstacles_;
  bool moving_ = false, placed_ = false;
  std::vector<std::shared_ptr<DraggedMotion>> dragged_; ///< of each obstacle; null: no hand was at it
  std::vector<RigidVelocity> velocity_;                 ///< of each obstacle, as last given
  std::vector<Standing> standing_;                      ///< those at rest first
  std::size_t at_rest_ = 0;                             ///< how many of them

  Field<Real> phi_, phi_rest_;                    ///< at the nodes; of those at rest
  std::vector<std::uint16_t> owner_, owner_rest_; ///< which one is nearest
  std::vector<std::uint8_t> near_;                ///< of each cell
  std::vector<std::uint8_t> inside_;              ///< of each cell: its centre lies in a solid
  std::vector<std::size_t> cut_;                  ///< cells whose centre does, but that are open in part
  Known<Dim> known_;                              ///< room of carry_change
  Components<Dim, Real> change_;                  ///< of velocity by the projection; room of constrain
};

} // namespace flipbook
