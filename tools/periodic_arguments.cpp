// SPDX-License-Identifier: BSD-3-Clause
#include "tools/periodic_arguments.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "adapters/io/naming.hpp"
#include "tools/joined_check.hpp"
#include "tools/number_check.hpp"
#include "tools/output_check.hpp"
#include "tools/warnings.hpp"

namespace multimesh::tools {

namespace {

using Vectors = std::array<std::array<double, 3>, 3>;

constexpr const char* side_names[] = {"flat", "free", "frozen"};

std::string check_axes(const std::string& s) {
  const bool good = !s.empty() && s.find_first_not_of("xyz") == std::string::npos &&
                    std::ranges::all_of(s, [&](char c) { return std::ranges::count(s, c) == 1; });
  return good ? std::string() : "must be some of the letters x, y, z, each once";
}

/// "1,0,0;0.5,1,0": three numbers per vector.
std::vector<std::array<double, 3>> vectors_of(const std::string& text) {
  std::vector<std::array<double, 3>> all;
  std::istringstream vectors(text);
  for (std::string one; std::getline(vectors, one, ';');) {
    auto& v = all.emplace_back();
    std::istringstream numbers(one);
    std::size_t i = 0;
    for (std::string number; std::getline(numbers, number, ','); ++i)
      if (i >= 3 || !CLI::detail::lexical_cast(number, v[i]) || !std::isfinite(v[i])) i = 9;
    if (i != 3) return {};
  }
  return all;
}

std::string check_periods(const std::string& s) {
  return vectors_of(s).empty() ? "must be vectors of three numbers, as in \"1,0,0;0.5,0.6,0\"" : "";
}

std::array<bool, 3> axes_of(const PeriodicArguments& a) {
  std::array<bool, 3> axes{};
  for (const char c : a.axes) axes[static_cast<std::size_t>(c - 'x')] = true;
  return axes;
}

std::optional<Vectors> periods_of(const PeriodicArguments& a) {
  if (a.periods.empty()) return std::nullopt;
  const auto vectors = vectors_of(a.periods);
  if (vectors.size() != a.axes.size())
    throw InputError("--periods: " + std::to_string(vectors.size()) + " vectors for the " +
                     std::to_string(a.axes.size()) + " axes of --periodic " + a.axes + "; give one per axis");
  Vectors periods{};
  for (std::size_t i = 0; i < vectors.size(); ++i)
    periods[static_cast<std::size_t>(a.axes[i] - 'x')] = vectors[i];
  return periods;
}

}  // namespace

CLI::Option* add_periodic_tile_options(CLI::App& command, PeriodicArguments& a) {
  auto* periodic = command.add_option("--periodic", a.axes,
                                      "the mesh is a tile of a pattern that repeats along these axes");
  periodic->check(CLI::Validator(check_axes, "AXES"))->group(periodic_group);
  command
      .add_option(
          "--periods", a.periods,
          "its period vectors, one per axis, as in \"1,0,0;0.5,0.6,0\"; default: those of $Periodic in "
          "the file, or the extents of its bounding box")
      ->check(CLI::Validator(check_periods, "X,Y,Z;..."))
      ->needs(periodic)
      ->group(periodic_group);
  command
      .add_option("--match-tolerance", a.tolerance,
                  "how far copies of a point may be from their places, relative to the diagonal")
      ->check(number([](double x) { return x > 0 && x < 0.1; }, "above 0 and below 0.1", "NUMBER"))
      ->capture_default_str()
      ->needs(periodic)
      ->group(periodic_group);
  return periodic;
}

void add_tile_output_options(CLI::App& command, PeriodicArguments& a) {
  auto* periodic = command.get_option("--periodic");
  command
      .add_option(
          "--sides", a.sides,
          "flat: flat sides stay where they are, and points move in them; free: the tile may be cut "
          "elsewhere; "
          "frozen: sides stay as they are. Default: flat; of triangles, free if not all sides are flat")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(side_names), std::end(side_names))))
      ->needs(periodic)
      ->group(periodic_group);
  command
      .add_option("--pair-table", a.pair_table,
                  "also write the copies of points as CSV: slave, master, lattice vector")
      ->needs(periodic)
      ->group(periodic_group);
  command
      .add_option("--abaqus-equations", a.equations,
                  "also write the copies as *EQUATION of Abaqus and CalculiX, with reference nodes")
      ->needs(periodic)
      ->group(periodic_group);
}

ReadTile read_periodic(const std::string& input, const PeriodicArguments& a) {
  files::TileFile file = files::read_tile(input);
  files::set_periods(file, axes_of(a), periods_of(a));
  file.options.tolerance = a.tolerance;
  file.options.corner_angle = a.corner_angle * std::numbers::pi / 180;
  if (a.feature_angle < 180) file.options.feature_angle = a.feature_angle * std::numbers::pi / 180;
  PeriodicDomain domain = io::naming(input, [&] { return PeriodicDomain(file.tile, file.options); });
  add(files::warnings_of(domain.report()), file.warnings);
  return {std::move(file), std::move(domain)};
}

std::optional<TileSides> requested_sides(const PeriodicArguments& a) {
  for (int i = 0; i < 3; ++i)
    if (a.sides == side_names[i]) return static_cast<TileSides>(i);
  return std::nullopt;
}
const char* name_of(TileSides sides) {
  return side_names[static_cast<std::size_t>(sides)];
}

void check_tile_outputs(const std::string& input, const std::string& output, const SimplexFormat& format,
                        const PeriodicArguments& a) {
  check_output_path(output, {input}, format);
  if (!a.pair_table.empty()) check_output_path(a.pair_table, {input, output});
  if (!a.equations.empty())
    check_output_path(a.equations, a.pair_table.empty()
                                       ? std::vector<std::filesystem::path>{input, output}
                                       : std::vector<std::filesystem::path>{input, output, a.pair_table});
}

std::vector<std::string> write_tile_outputs(const std::string& output, const TileTopology& before,
                                            const TileTopology& after, const PeriodicDomain& domain,
                                            const files::TileFile& file,
                                            const io::SimplexWriteOptions& options, double sizes,
                                            const PeriodicArguments& a) {
  auto warnings = write_if_same_mesh(output, before, after, domain, file.groups, options, sizes);
  if (!a.pair_table.empty()) files::write_pair_table(a.pair_table, domain, options.order);
  if (!a.equations.empty()) files::write_abaqus_equations(a.equations, domain, options.order);
  return warnings;
}

std::vector<std::string> dropped_from_sides(std::size_t n) {
  if (n == 0) return {};
  return {std::to_string(n) +
          " listed points, edges or triangles in the sides are dropped, because the sides "
          "are free"};
}

Json to_json(const PeriodicDomain& now, const TileTopology& t) {
  Json j;
  j["periods"] = Json::object();
  for (std::size_t i = 0; i < 3; ++i) {
    if (!now.lattice().is_periodic(static_cast<int>(i))) continue;
    LatticeVector unit{};
    unit[i] = 1;
    const Vec3 v = now.lattice().shift(unit);
    j["periods"][std::string(1, "xyz"[i])] = {v[0], v[1], v[2]};
  }
  j["glued"] = {{"vertices", t.simplices[0]},
                {"edges", t.simplices[1]},
                {"triangles", t.simplices[2]},
                {"tetrahedra", t.simplices[3]},
                {"euler_characteristic", t.euler}};
  j["copies"] = Json::object();
  for (std::size_t n = 1; n < t.with_copies.size(); ++n)
    if (t.with_copies[n] > 0) j["copies"][std::to_string(n)] = t.with_copies[n];
  j["sides"] = Json::array();
  for (const PeriodicSide& side : now.sides())
    j["sides"].push_back({{"vector", multimesh::name_of(side.shift)}, {"faces", side.master.size()}});
  j["flat_sides"] = now.has_flat_sides();
  j["mismatch"] = t.mismatch;
  j["inverted"] = t.inverted;
  return j;
}

}  // namespace multimesh::tools
