// SPDX-License-Identifier: BSD-3-Clause
// From a file to a domain and back, with materials, groups and tags: a textured surface, tetrahedra, a
// periodic tile. Sentences report what was unusual about a file, and what a format cannot store.
#include <iostream>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/files/domain_file.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/files/tile_file.hpp"

using namespace multimesh;
namespace fs = std::filesystem;

void tell(const std::vector<std::string>& warnings) {
  for (const std::string& w : warnings) std::cerr << "warning: " << w << '\n';
}

/// A textured surface, with a tenth of its triangles.
void decimate_file(const fs::path& in, const fs::path& out) {
  files::SurfaceFile file = files::read_surface(in);
  TexturedSurface surface = files::take_surface(file);
  decimate(surface, {.faces = surface.live_triangles() / 10});
  tell(files::write_surface(out, surface, file));
  tell(file.warnings);
}

/// Tetrahedra, with regions, patches and curves.
void convert_file(const fs::path& in, const fs::path& out) {
  files::DomainFile file = files::read_domain(in, {.no_periodic = true});
  const TetDomain domain = files::take_domain(file);
  tell(files::write_domain(out, domain, file));
  tell(file.warnings);
}

/// A periodic tile, glued as its file specifies.
PeriodicDomain glue_file(const fs::path& in) {
  const files::TileFile file = files::read_tile(in);
  tell(file.warnings);
  return PeriodicDomain(file.tile, file.options);
}

/// n^2 squares of two triangles.
PeriodicTile square(Index n) {
  PeriodicTile tile{{}, {2, (n + 1) * (n + 1), {}}};
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j) tile.points.push_back({double(i) / n, double(j) / n, 0});
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const Index a = i * (n + 1) + j, b = a + n + 1;
      tile.facets.corners.insert(tile.facets.corners.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  return tile;
}

int main(int, char** arguments) try {
  const fs::path folder = fs::temp_directory_path() / "multimesh_example_files";
  fs::create_directories(folder);
  const fs::path model = arguments[1];

  decimate_file(model, folder / "small.obj");
  const files::SurfaceFile before = files::read_surface(model),
                           after = files::read_surface(folder / "small.obj");
  std::cout << before.input.triangles.size() << " triangles -> " << after.input.triangles.size() << '\n';
  const bool material = before.section_of(0).material == after.section_of(0).material;

  TaggedTetrahedra one;
  one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  one.tets = {3, 4, {0, 1, 2, 3}};
  one.regions = {7};
  files::write_domain(folder / "one.msh", one, {{{3, 7, "steel"}}, {}});
  convert_file(folder / "one.msh", folder / "one.vtu");
  const files::DomainFile converted = files::read_simplices(folder / "one.vtu");

  PeriodicOptions options;
  options.axes = {true, true, false};
  files::write_tile(folder / "tile.msh", PeriodicDomain(square(4), options));
  const PeriodicDomain torus = glue_file(folder / "tile.msh");
  std::cout << "Euler characteristic of the tile, glued: " << torus.report().euler << '\n';

  fs::remove_all(folder);
  return material && converted.soup.simplices[3].tags == std::vector{7} && torus.report().euler == 0 ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
