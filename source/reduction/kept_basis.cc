// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chaindrive/reduction/kept_basis.h>
#include <chaindrive/reduction/slower_modes.h>
#include <chaindrive/utilities/checksum.h>
#include <chaindrive/utilities/first_rank.h>
#include <chaindrive/utilities/text.h>
#include <chaindrive/version.h>

#include <algorithm>
#include <cstring>

namespace chaindrive::reduction
{
namespace
{
/// Of what is kept: to be raised with every change that changes results.
constexpr unsigned int version = 2;

void add(Checksum &sum, const double *values, const std::size_t n)
{
  sum.add(reinterpret_cast<const char *>(values), n * sizeof(double));
}

/// All that a basis follows from: mesh, material and elements are in the numbers of the matrices
/// and of the @p tractions.
std::string
key_of(const FreePart &part, const std::vector<Vector> &tractions, const BasisOptions &options)
{
  Checksum sum;
  for (unsigned int row = 0; row < part.n_unknowns(); ++row)
    for (auto entry = part.stiffness().begin(row); entry != part.stiffness().end(row); ++entry)
      {
        const double column = entry->column(), value = entry->value();
        add(sum, &column, 1);
        add(sum, &value, 1);
      }
  const Vector &mass = part.mass().get_vector();
  add(sum, mass.begin(), mass.size());
  for (const std::vector<Vector> &vectors : {part.rigid(), tractions})
    for (const Vector &vector : vectors)
      add(sum, vector.begin(), vector.size());
  return "basis of the " + part.name() + "; " + std::to_string(part.n_unknowns()) +
         " unknowns; matrices and tractions " + std::to_string(sum.value()) + "; modes up to " +
         to_text(options.modes_up_to, 12) + "; cap " + to_text(options.cap, 12) + "; negligible " +
         to_text(options.negligible, 12) +
         (options.orders.in_joints ? "" : "; joints without inertia") +
         (options.orders.on_teeth ? "" : "; outside without inertia") + "; version " +
         std::to_string(version) + " of " + chaindrive::version;
}

/// The numbers of all @p vectors, one after the other, bit by bit.
std::string to_base64(const std::vector<Vector> &vectors)
{
  std::vector<unsigned char> bytes;
  for (const Vector &vector : vectors)
    {
      const auto *first = reinterpret_cast<const unsigned char *>(vector.begin());
      bytes.insert(bytes.end(), first, first + vector.size() * sizeof(double));
    }
  return dealii::Utilities::encode_base64(bytes);
}

/// @p n of the vectors that to_base64() has written.
std::vector<Vector> from_base64(const std::string &text, const std::size_t n)
{
  const std::vector<unsigned char> bytes = dealii::Utilities::decode_base64(text);
  const std::size_t                size  = n == 0 ? 0 : bytes.size() / (n * sizeof(double));
  std::vector<Vector>              vectors(n, Vector(size));
  for (std::size_t i = 0; i < n; ++i)
    std::memcpy(
        vectors[i].begin(), bytes.data() + i * size * sizeof(double), size * sizeof(double));
  return vectors;
}

std::string to_base64(const std::vector<double> &numbers)
{
  return to_base64(std::vector<Vector>{Vector(numbers.begin(), numbers.end())});
}

nlohmann::json to_json(const RoundFlexibility &side)
{
  nlohmann::json json = {{"surface", static_cast<unsigned int>(side.surface)},
                         {"rings", to_base64(side.rings)},
                         {"columns", side.n_columns},
                         {"nodes", side.node},
                         {"m/N", to_base64(side.value)}};
  if (!side.to_bore.empty())
    json["to bore, m/N"] = to_base64(side.to_bore);
  return json;
}

/// Whether @p json is what to_json() writes of a side of a part with @p n_unknowns.
bool is_round_flexibility(const nlohmann::json &json, const std::size_t n_unknowns)
{
  const std::size_t rings =
      dealii::Utilities::decode_base64(json.at("rings")).size() / sizeof(double);
  const nlohmann::json &columns = json.at("columns");
  const auto           &nodes   = json.at("nodes").get_ref<const nlohmann::json::array_t &>();
  return json.at("surface").is_number_unsigned() && json["surface"] < mesh::n_surfaces &&
         columns.is_number_unsigned() && columns > 0 && rings > 0 &&
         nodes.size() == rings * columns.get<std::size_t>() &&
         std::all_of(nodes.begin(),
                     nodes.end(),
                     [n_unknowns](const nlohmann::json &node) {
                       return node.is_number_unsigned() && 3 * node.get<std::size_t>() < n_unknowns;
                     }) &&
         dealii::Utilities::decode_base64(json.at("m/N")).size() ==
             nodes.size() * rings * sizeof(double) &&
         (!json.contains("to bore, m/N") ||
          dealii::Utilities::decode_base64(json["to bore, m/N"]).size() %
                  (nodes.size() * sizeof(double)) ==
              0);
}

RoundFlexibility round_flexibility_from(const nlohmann::json &json)
{
  const auto numbers = [&json](const char *name) {
    const std::vector<unsigned char> bytes = dealii::Utilities::decode_base64(json.at(name));
    std::vector<double>              found(bytes.size() / sizeof(double));
    std::memcpy(found.data(), bytes.data(), bytes.size());
    return found;
  };
  RoundFlexibility side;
  side.surface   = static_cast<mesh::Surface>(json.at("surface").get<unsigned int>());
  side.rings     = numbers("rings");
  side.n_columns = json.at("columns");
  side.node      = json.at("nodes").get<std::vector<unsigned int>>();
  side.value     = numbers("m/N");
  if (json.contains("to bore, m/N"))
    side.to_bore = numbers("to bore, m/N");
  return side;
}

nlohmann::json to_json(const Basis &basis)
{
  nlohmann::json errors = nlohmann::json::array();
  for (const Basis::Error &error : basis.errors)
    errors.push_back({error.load, error.relative});
  nlohmann::json json = {{"natural", basis.n_natural},
                         {"rad/s", basis.omega},
                         {"shapes", to_base64(basis.modes)},
                         {"reflections", basis.reflections},
                         {"symmetry", basis.symmetry},
                         {"errors", errors}};
  for (const RoundFlexibility &side : basis.joints)
    json["joints"].push_back(to_json(side));
  return json;
}

/// Whether @p json is a basis of a part with @p n_unknowns, as to_json() writes it.
bool is_basis(const nlohmann::json &json, const std::size_t n_unknowns)
{
  const auto       &omega       = json.at("rad/s").get_ref<const nlohmann::json::array_t &>();
  const auto       &reflections = json.at("reflections").get_ref<const nlohmann::json::array_t &>();
  const auto       &symmetry    = json.at("symmetry").get_ref<const nlohmann::json::array_t &>();
  const std::size_t n           = omega.size();
  const std::size_t bytes       = dealii::Utilities::decode_base64(json.at("shapes")).size();
  const auto        below       = [](const unsigned int end) {
    return [end](const nlohmann::json &number) {
      return number.is_number_unsigned() && number.get<unsigned int>() < end;
    };
  };
  if (!(n > 0 && json.at("natural").is_number_unsigned() && json["natural"] <= n &&
        bytes == n * n_unknowns * sizeof(double) && symmetry.size() == n &&
        reflections.size() <= 3))
    return false;
  for (const nlohmann::json &error : json.at("errors"))
    if (!error.at(0).is_string() || !error.at(1).is_number())
      return false;
  if (json.contains("joints"))
    for (const nlohmann::json &side : json["joints"])
      if (!is_round_flexibility(side, n_unknowns))
        return false;
  return std::all_of(
             omega.begin(),
             omega.end(),
             [](const nlohmann::json &w) { return w.is_number() && w.get<double>() > 0.; }) &&
         std::all_of(reflections.begin(), reflections.end(), below(3)) &&
         std::all_of(symmetry.begin(), symmetry.end(), below(1U << reflections.size()));
}

Basis from_json(const nlohmann::json &json)
{
  Basis basis;
  basis.n_natural   = json.at("natural");
  basis.omega       = json.at("rad/s").get<std::vector<double>>();
  basis.modes       = from_base64(json.at("shapes"), basis.size());
  basis.reflections = json.at("reflections").get<std::vector<unsigned int>>();
  basis.symmetry    = json.at("symmetry").get<std::vector<unsigned int>>();
  for (const nlohmann::json &error : json.at("errors"))
    basis.errors.push_back({error.at(0), error.at(1)});
  if (json.contains("joints"))
    for (const nlohmann::json &side : json["joints"])
      basis.joints.push_back(round_flexibility_from(side));
  return basis;
}
} // namespace

BasisOptions options_of(const parameters::Reduction &reduction,
                        const double                 pitch,
                        const bool                   pressed_joints,
                        const bool                   pressed_outside,
                        const bool                   pressed_faces)
{
  using dealii::numbers::PI;
  const double faster = std::max(1., 15.875e-3 / pitch);
  BasisOptions options;
  options.modes_up_to =
      2. * PI * reduction.modes_up_to.value_or(pressed_joints ? 60e3 : faster * 120e3);
  options.cap = 2. * PI * reduction.highest;
  if (reduction.fastest_of_links || !pressed_joints)
    options.fastest_of_links = 2. * PI * reduction.fastest_of_links.value_or(faster * 80e3);
  if (!pressed_joints && !pressed_outside)
    options.fastest_of_rollers = 2. * PI * reduction.fastest_of_rollers.value_or(faster * 90e3);
  options.orders = {
      reduction.tube_order, reduction.pin_order, pressed_joints, pressed_outside, pressed_faces};
  return options;
}

Basis kept_basis(const mesh::Part           &part,
                 const Material             &material,
                 const parameters::Elements &elements,
                 const BasisOptions         &options,
                 statics::Cache             &cache,
                 const MPI_Comm              comm,
                 const Announce             &announce)
{
  std::string kept;
  on_first_rank(comm, [&] {
    const mesh::Nodes          nodes(part);
    const element::ElasticPart elastic(part, nodes, material, elements);
    const FreePart             free(part, nodes, elastic);
    const std::vector<Vector>  loads = tractions(part, nodes, options.orders);
    const std::string          key   = key_of(free, loads, options);
    const auto                 fits  = [&free](const nlohmann::json &json) {
      return is_basis(json, free.n_unknowns());
    };
    if (const auto found = cache.find(key, fits))
      {
        kept = found->dump();
        return;
      }
    if (announce)
      announce("Finding the modes of the " + part.name + ", which are kept for later runs ...");
    Basis basis = make_basis(free, loads, options);
    if (!options.orders.in_joints)
      basis.joints = round_flexibilities(free, part, nodes, basis, !options.orders.on_teeth);
    for (const Load &load : contact_loads(part, nodes))
      basis.errors.push_back({load.name, static_error(free, basis, load.force)});
    const nlohmann::json json = to_json(basis);
    cache.keep(key, json);
    kept = json.dump();
  });
  if (n_ranks_in(comm) > 1)
    kept = dealii::Utilities::MPI::broadcast(comm, kept);
  Basis basis = from_json(nlohmann::json::parse(kept));
  slow_down(part, options, basis);
  basis.notes = cache.notes();
  return basis;
}
} // namespace chaindrive::reduction
