// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/factored_stiffness.h>
#include <chaindrive/reduction/free_part.h>

#include <algorithm>
#include <cmath>

namespace chaindrive::reduction
{
namespace
{
using dealii::Tensor;

/// The unknown that each of the linearly independent @p motions moves most, less what those before
/// it move: Gauss' elimination.
std::vector<unsigned int> pivots(std::vector<Vector> motions)
{
  std::vector<unsigned int> found;
  for (std::size_t m = 0; m < motions.size(); ++m)
    {
      const Vector &motion = motions[m];
      const auto    most =
          std::max_element(motion.begin(), motion.end(), [](const double a, const double b) {
            return std::abs(a) < std::abs(b);
          });
      found.push_back(static_cast<unsigned int>(most - motion.begin()));
      for (std::size_t other = m + 1; other < motions.size(); ++other)
        motions[other].add(-motions[other][found.back()] / *most, motion);
    }
  return found;
}

/// Whether the unknown @p i is held: in the middle plane of a half part, across it.
bool is_held(const mesh::Part &part, const mesh::Nodes &nodes, const unsigned int i)
{
  return part.half && i % 3 == 2 && nodes.position[i / 3][2] == 0.;
}

/// What the reflection @p r makes of @p u.
Vector reflected(const Vector &u, const Symmetry &symmetry, const unsigned int r)
{
  Vector image(u.size());
  for (unsigned int node = 0; node < symmetry.mirror[r].size(); ++node)
    for (unsigned int d = 0; d < 3; ++d)
      image[3 * symmetry.mirror[r][node] + d] =
          d == symmetry.axis[r] ? -u[3 * node + d] : u[3 * node + d];
  return image;
}

/// a^T M b.
double mass_product(const mesh::Nodes &nodes, const Vector &a, const Vector &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += nodes.mass[i / 3] * a[i] * b[i];
  return sum;
}
} // namespace

std::vector<Vector> rigid_motions(const mesh::Part &part, const mesh::Nodes &nodes)
{
  Tensor<1, 3> centre;
  double       mass = 0.;
  for (unsigned int a = 0; a < nodes.size(); ++a)
    {
      centre += nodes.mass[a] * nodes.position[a];
      mass += nodes.mass[a];
    }
  centre /= mass;

  std::vector<Vector> motions;
  for (unsigned int i = 0; i < 6; ++i)
    {
      Tensor<1, 3> axis;
      axis[i % 3] = 1.;
      Vector motion(3 * nodes.size());
      bool   allowed = true;
      for (unsigned int n = 0; n < motion.size(); ++n)
        {
          const Tensor<1, 3> u =
              i < 3 ? axis : cross_product_3d(axis, nodes.position[n / 3] - centre);
          motion[n] = u[n % 3];
          allowed   = allowed && (!is_held(part, nodes, n) || motion[n] == 0.);
        }
      if (!allowed)
        continue;
      for (unsigned int pass = 0; pass < 2; ++pass)
        for (const Vector &other : motions)
          motion.add(-mass_product(nodes, other, motion), other);
      motion /= std::sqrt(mass_product(nodes, motion, motion));
      motions.push_back(motion);
    }
  return motions;
}

FreePart::FreePart(const mesh::Part           &part,
                   const mesh::Nodes          &nodes,
                   const element::ElasticPart &elastic)
    : name_(part.name), held_(3 * nodes.size(), 0)
{
  std::vector<const element::ElementBlock *> blocks;
  for (const auto &block : elastic.blocks())
    blocks.push_back(block.get());
  element::assemble(blocks, nodes.size(), pattern_, stiffness_);

  Vector mass(3 * nodes.size());
  for (unsigned int i = 0; i < mass.size(); ++i)
    {
      mass[i]  = nodes.mass[i / 3];
      held_[i] = reduction::is_held(part, nodes, i);
    }
  mass_.reinit(mass);

  rigid_    = rigid_motions(part, nodes);
  supports_ = pivots(rigid_);

  for (unsigned int axis = 0; axis < 3; ++axis)
    {
      Symmetry one;
      one.axis   = {axis};
      one.mirror = {mirror_images(nodes, axis)};
      if (!one.mirror[0].empty() && commutes(one))
        {
          symmetry_.axis.push_back(axis);
          symmetry_.mirror.push_back(one.mirror[0]);
        }
    }
}

bool FreePart::commutes(const Symmetry &reflection) const
{
  Vector u(n_unknowns());
  for (unsigned int i = 0; i < u.size(); ++i)
    u[i] = std::sin(1. + 12.9898 * i); // no symmetry
  const auto differ = [](Vector a, const Vector &b) {
    const double size = b.linfty_norm();
    a -= b;
    return a.linfty_norm() > 1e-9 * size;
  };
  const Vector image = reflected(u, reflection, 0);
  Vector       of_u(u.size()), of_image(u.size());
  stiffness_.vmult(of_u, u);
  stiffness_.vmult(of_image, image);
  if (differ(of_image, reflected(of_u, reflection, 0)))
    return false;
  mass_.vmult(of_u, u);
  mass_.vmult(of_image, image);
  return !differ(of_image, reflected(of_u, reflection, 0));
}

Vector FreePart::part_of_class(const Vector &u, const unsigned int c) const
{
  Vector part = u;
  for (unsigned int r = 0; r < symmetry_.axis.size(); ++r)
    part.sadd(0.5, (c >> r & 1u) != 0 ? -0.5 : 0.5, reflected(part, symmetry_, r));
  return part;
}

double FreePart::mass_product(const Vector &a, const Vector &b) const
{
  double        sum  = 0.;
  const Vector &mass = mass_.get_vector();
  for (unsigned int i = 0; i < n_unknowns(); ++i)
    sum += mass[i] * a[i] * b[i];
  return sum;
}

std::vector<unsigned int> FreePart::fixed_unknowns() const
{
  std::vector<unsigned int> fixed = supports_;
  for (unsigned int i = 0; i < n_unknowns(); ++i)
    if (is_held(i))
      fixed.push_back(i);
  return fixed;
}

dealii::SparseMatrix<double> FreePart::supported_stiffness() const
{
  dealii::SparseMatrix<double> supported(pattern_);
  supported.copy_from(stiffness_);
  for (const unsigned int i : fixed_unknowns())
    for (auto entry = supported.begin(i); entry != supported.end(i); ++entry)
      if (entry->column() != i)
        {
          supported.set(entry->column(), i, 0.);
          entry->value() = 0.;
        }
  return supported;
}

struct FreePart::QuickInverse
{
  FactoredStiffness   stiffness;
  std::vector<Vector> inertia; ///< M R of each rigid motion
};

FreePart::~FreePart() = default;

Vector FreePart::displacement(const Vector &force) const
{
  if (!inverse_)
    {
      inverse_ = std::make_unique<dealii::SparseDirectUMFPACK>();
      inverse_->initialize(supported_stiffness());
    }

  Vector balanced = force, u(n_unknowns());
  for (unsigned int i = 0; i < n_unknowns(); ++i)
    if (is_held(i))
      balanced[i] = 0.;
  for (const Vector &motion : rigid_)
    {
      mass_.vmult(u, motion);
      balanced.add(-(motion * force), u);
    }
  for (const unsigned int i : fixed_unknowns())
    balanced[i] = 0.;
  inverse_->vmult(u, balanced);
  for (const Vector &motion : rigid_)
    u.add(-mass_product(motion, u), motion);
  return u;
}

std::vector<Vector> FreePart::displacements(const std::vector<Vector> &forces) const
{
  if (!quick_)
    {
      quick_ = std::make_unique<QuickInverse>(
          QuickInverse{FactoredStiffness(supported_stiffness()),
                       std::vector<Vector>(rigid_.size(), Vector(n_unknowns()))});
      for (std::size_t m = 0; m < rigid_.size(); ++m)
        mass_.vmult(quick_->inertia[m], rigid_[m]);
    }
  const std::vector<Vector>      &inertia = quick_->inertia;
  const std::vector<unsigned int> fixed   = fixed_unknowns();
  std::vector<Vector>             u       = forces;
  for (std::size_t f = 0; f < u.size(); ++f)
    {
      for (std::size_t m = 0; m < rigid_.size(); ++m)
        u[f].add(-(rigid_[m] * forces[f]), inertia[m]);
      for (const unsigned int i : fixed)
        u[f][i] = 0.;
    }
  quick_->stiffness.solve(u);
  for (Vector &of_force : u)
    for (std::size_t m = 0; m < rigid_.size(); ++m)
      of_force.add(-(inertia[m] * of_force), rigid_[m]);
  return u;
}
} // namespace chaindrive::reduction
