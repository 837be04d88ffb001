// SPDX-License-Identifier: BSD-3-Clause
// Operations per second on tetrahedral meshes, in random order, alone and with children.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <random>
#include <string>

#include "test/benchmark/tet_tree.hpp"

namespace multimesh::bench {
namespace {

using ::benchmark::Counter;

Outcome split(TetTree& t, Dart e) {
  return t.operations().split(NodeId::root, e);
}
Outcome collapse(TetTree& t, Dart e) {
  return t.operations().collapse(NodeId::root, e);
}
Outcome swap(TetTree& t, Dart e) {
  return t.operations().swap(NodeId::root, e);
}
Outcome swap_face(TetTree& t, Dart f) {
  return t.operations().swap_face(NodeId::root, f);
}

/// Bytes that the program has allocated.
std::size_t allocated() {
  const auto m = mallinfo2();
  return m.uordblks + m.hblkhd;
}

/// Requests the operation at a random dart of a tenth of the tetrahedra, leaving out dead ones.
template <Outcome (*operation)(TetTree&, Dart)>
void run(::benchmark::State& state, unsigned children) {
  const auto n = static_cast<Index>(state.range(0));
  std::size_t tried = 0, done = 0, tets = 0, bytes = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const std::size_t before = allocated();
    std::optional<TetTree> tree(std::in_place, n, children);
    bytes = allocated() - before;
    tets = tree->root().capacity(3);
    std::vector<Index> order(tets);
    std::iota(order.begin(), order.end(), Index{0});
    std::mt19937 random(1);
    std::shuffle(order.begin(), order.end(), random);
    order.resize(std::max<std::size_t>(tets / 10, 1));
    state.ResumeTiming();
    for (const Index t : order) {
      if (!tree->root().is_live(3, t)) continue;
      ++tried;
      done += bool(operation(*tree, tet::TetMesh::dart(t, {static_cast<std::uint8_t>(random() % 24)})));
    }
    state.PauseTiming();
    tree.reset();
    state.ResumeTiming();
  }
  state.counters["tets"] = static_cast<double>(tets);
  state.counters["bytes/tet"] = static_cast<double>(bytes) / static_cast<double>(tets);
  state.counters["refused"] = 1 - static_cast<double>(done) / static_cast<double>(tried);
  state.counters["ops/s"] = Counter(static_cast<double>(done), Counter::kIsRate);
  state.counters["tries/s"] = Counter(static_cast<double>(tried), Counter::kIsRate);
}

template <Outcome (*operation)(TetTree&, Dart)>
void add_benchmarks(const std::string& name) {
  const auto add = [&](const std::string& variant, unsigned children) {
    auto* b = ::benchmark::RegisterBenchmark((name + "/" + variant).c_str(), run<operation>, children);
    b->Arg(8)->Arg(22)->Arg(55)->Unit(::benchmark::kMillisecond);  // 3,072; 63,888; 998,250 tetrahedra
  };
  add("alone", tets_alone);
  add("boundary", outer_surface);
  add("surface", inner_surface);
  add("surface+curve", inner_surface | inner_curve);
  add("boundary+surface+curve", outer_surface | inner_surface | inner_curve);
}

}  // namespace
}  // namespace multimesh::bench

int main(int argc, char** argv) {
  using namespace multimesh::bench;
  add_benchmarks<split>("split");
  add_benchmarks<collapse>("collapse");
  add_benchmarks<swap>("swap");
  add_benchmarks<swap_face>("swap_face");
  ::benchmark::Initialize(&argc, argv);
  if (::benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  ::benchmark::RunSpecifiedBenchmarks();
}
