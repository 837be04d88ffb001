// SPDX-License-Identifier: BSD-3-Clause
// One decimation to 10% of the faces, with the same queue, costs and updates: on bare OpenMesh, on a
// multimesh with only the root, and with children; also OpenMesh's own decimater. compare.py runs them side
// by side and prints the ratios.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "test/benchmark/decimation.hpp"

namespace multimesh::bench {
namespace {

using ::benchmark::Counter;

ChartedShape sphere(std::int64_t n) {
  return charted_sphere(static_cast<Index>(n));
}
ChartedShape torus(std::int64_t n) {
  return charted_torus(static_cast<Index>(n), static_cast<Index>(n));
}

using MakeShape = ChartedShape (*)(std::int64_t);

std::size_t target(const ChartedShape& charted) {
  return charted.shape.facets.size() / 10;
}

void report(::benchmark::State& state, const ChartedShape& charted, const Decimation& done) {
  state.counters["faces"] = static_cast<double>(charted.shape.facets.size());
  state.counters["faces_left"] = static_cast<double>(done.faces);
  state.counters["collapses"] = static_cast<double>(done.collapses);
  state.counters["checksum"] = done.checksum;
  state.counters["collapses/s"] =
      Counter(static_cast<double>(done.collapses), Counter::kIsIterationInvariantRate);
}

using DecimateMesh = Decimation (*)(SurfaceMesh&, std::size_t);

void on_openmesh(::benchmark::State& state, MakeShape make, DecimateMesh decimate) {
  const ChartedShape charted = make(state.range(0));
  Decimation done;
  for (auto _ : state) {
    state.PauseTiming();
    SurfaceMesh mesh = surface_mesh(charted.shape);
    state.ResumeTiming();
    done = decimate(mesh, target(charted));
  }
  report(state, charted, done);
}

void on_tree(::benchmark::State& state, MakeShape make, unsigned children) {
  const ChartedShape charted = make(state.range(0));
  Decimation done;
  for (auto _ : state) {
    state.PauseTiming();
    std::optional<SurfaceTree> tree(std::in_place, charted, children);
    state.counters["map_bytes/face"] =
        static_cast<double>(tree->map_bytes()) / static_cast<double>(charted.shape.facets.size());
    state.ResumeTiming();
    done = decimate_tree(*tree, target(charted));
    state.PauseTiming();
    tree.reset();
    state.ResumeTiming();
  }
  report(state, charted, done);
}

void add_benchmarks(const std::string& name, MakeShape make, const std::vector<std::int64_t>& sizes) {
  const auto add = [&](const std::string& variant, const auto& run) {
    auto* b = ::benchmark::RegisterBenchmark((name + "/" + variant).c_str(), run);
    for (const std::int64_t n : sizes) b->Arg(n);
    b->Unit(::benchmark::kMillisecond);
  };
  add("bare", [=](auto& state) { on_openmesh(state, make, decimate_bare); });
  add("root", [=](auto& state) { on_tree(state, make, alone); });
  add("uv", [=](auto& state) { on_tree(state, make, texture); });
  add("uv+seams", [=](auto& state) { on_tree(state, make, texture | seams); });
  add("decimater", [=](auto& state) { on_openmesh(state, make, decimate_by_decimater); });
}

}  // namespace
}  // namespace multimesh::bench

int main(int argc, char** argv) {
  // Sizes x8 apart, up to 1,310,720 and 1,048,352 faces.
  multimesh::bench::add_benchmarks("sphere", multimesh::bench::sphere, {11, 32, 90, 256});
  multimesh::bench::add_benchmarks("torus", multimesh::bench::torus, {32, 90, 256, 724});
  ::benchmark::Initialize(&argc, argv);
  if (::benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  ::benchmark::RunSpecifiedBenchmarks();
}
