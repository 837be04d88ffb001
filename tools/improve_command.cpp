// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "multimesh/error.hpp"
#include "tools/command.hpp"
#ifdef MULTIMESH_WITH_IMPROVE
#include "adapters/io/naming.hpp"
#include "multimesh/algorithms/improve.hpp"
#include "multimesh/files/formats.hpp"
#include "multimesh/geometry/bounding_box.hpp"
#include "tools/domain_arguments.hpp"
#include "tools/joined_check.hpp"
#include "tools/mesh_page.hpp"
#include "tools/number_check.hpp"
#include "tools/output_check.hpp"
#include "tools/periodic_arguments.hpp"
#include "tools/quality_json.hpp"
#include "tools/tile_page.hpp"
#include "tools/warnings.hpp"
#endif

namespace multimesh::tools {

#ifdef MULTIMESH_WITH_IMPROVE

namespace {

struct ImproveArguments {
  std::string input, output, splits = "rounded";
  ReportOptions report;
  std::vector<std::string> locked_patches;
  double feature_angle = 0, relative_envelope = 0;
  DomainImproveOptions options;
  files::DomainReadOptions taken;
  SimplexFormat format;
  PeriodicArguments periodic;
  bool progress = false;

  void set_splits();
};

constexpr const char* split_names[] = {"none", "exact", "rounded"};
void ImproveArguments::set_splits() {
  for (int i = 0; i < 3; ++i)
    if (splits == split_names[i]) options.surface_splits = static_cast<SurfaceSplits>(i);
}

constexpr const char* stop_names[] = {"nothing_left", "max_passes", "max_growth", "time_limit"};

Json to_json(const ImproveArguments& a, const ImproveResult& r) {
  Json j{{"input", a.input},
         {"output", a.output},
         {"target_amips", a.options.target_amips},
         {"target_reached", r.target_reached},
         {"stopped_by", stop_names[static_cast<std::size_t>(r.stop)]},
         {"passes", r.passes},
         {"seconds", r.seconds},
         {"before", tools::to_json(r.before)},
         {"after", tools::to_json(r.after)}};
  for (const OperationCount& c : r.operations) {
    Json refused = Json::object();
    for (const auto& [reason, n] : c.refused) refused[reason] = n;
    j["operations"][c.name] = {{"tried", c.tried}, {"done", c.done}, {"refused", refused}};
  }
  if (a.options.has_sizes())
    j["edge_lengths"] = {{"target", a.options.edge_length}, {"max", a.options.max_edge_length},
                         {"shortest", r.lengths.shortest},  {"mean", r.lengths.mean},
                         {"longest", r.lengths.longest},    {"share_in_range", r.lengths.share_in_range},
                         {"too_long", r.lengths.too_long}};
  for (const EnvelopeUse& e : r.envelopes)
    j["envelopes"].push_back({{"distance", e.distance}, {"moved", e.moved[0]}, {"moved_from", e.moved[1]}});
  j["least_max_amips"] = {{"value", r.least_max_amips}, {"at", r.least_max_amips_at}};
  j["obstacles"] = Json::array();
  for (const ImproveObstacle& o : r.obstacles)
    j["obstacles"].push_back({{"reason", o.reason},
                              {"tetrahedra", o.tets},
                              {"max_amips", o.max_amips},
                              {"least_max_amips", o.least_max_amips},
                              {"example", o.example}});
  return j;
}

void print(const ImproveArguments& a, const ImproveResult& r) {
  std::cout << a.output << '\n' << std::setprecision(4);
  const auto line = [&](const char* when, const TetQuality& q) {
    std::cout << "  " << when << "  " << q.tets << " tetrahedra, AMIPS max " << q.max_amips << ", mean "
              << q.mean_amips << ", " << q.above_target << " above " << a.options.target_amips << '\n';
  };
  line("before:", r.before);
  line("after: ", r.after);
  std::cout << "  done:   ";
  for (const OperationCount& c : r.operations)
    std::cout << (&c == &r.operations.front() ? " " : ", ") << c.done << " of " << c.tried << ' ' << c.name;
  std::cout << "\n           in " << r.passes << " passes, " << r.seconds << " s\n";
  for (const EnvelopeUse& e : r.envelopes)
    std::cout << "  moved:  the surface by " << e.moved[0] << ", what it was is " << e.moved[1]
              << " from it, of at most " << e.distance << '\n';
}

std::string place(const std::array<double, 3>& p) {
  std::ostringstream text;
  text << std::setprecision(6) << '(' << p[0] << ", " << p[1] << ", " << p[2] << ')';
  return text.str();
}

std::string number(double x) {
  std::ostringstream text;
  text << std::setprecision(4) << x;
  return text.str();
}

/// Whether the edges reached the length, in a sentence; empty if all did.
std::string length_missed(double length, const EdgeLengths& m) {
  if (m.too_long == 0 && m.share_in_range >= 0.9) return {};
  return "the edge length was missed: " + number(100 * m.share_in_range) +
         " % of the edges are from 4/5 to 4/3 of " + number(length) + ", " + std::to_string(m.too_long) +
         " are longer; the longest is " + number(m.longest) + ", the mean " + number(m.mean);
}

std::string stop_reason(const ImproveArguments& a, ImproveStop stop) {
  switch (stop) {
    case ImproveStop::max_passes:
      return "stopped after " + std::to_string(a.options.max_passes) + " passes (--max-passes)";
    case ImproveStop::max_growth:
      return "no edge was split any more when the mesh had grown to its limit (--max-growth " +
             number(a.options.max_growth) + ")";
    case ImproveStop::time_limit:
      return "stopped after " + number(a.options.time_limit) + " s (--time-limit)";
    default:
      return {};
  }
}

/// Why a target was missed, in sentences.
std::vector<std::string> reasons(const ImproveArguments& a, const ImproveResult& r) {
  std::vector<std::string> list;
  if (a.options.edge_length > 0)
    if (const std::string missed = length_missed(a.options.edge_length, r.lengths); !missed.empty())
      list.push_back(missed);
  if (const double most = a.options.max_edge_length; most > 0 && r.lengths.longest > most)
    list.push_back("the longest edge has a length of " + number(r.lengths.longest) +
                   ", more than --max-edge-length " + number(most));
  if (const std::string stop = stop_reason(a, r.stop); !stop.empty()) list.push_back(stop);
  for (const EnvelopeUse& e : r.envelopes)
    if (std::max(e.moved[0], e.moved[1]) > e.distance * (1 + 1e-9))
      list.push_back("the surface left its envelope of " + number(e.distance) +
                     " by rounding: " + number(std::max(e.moved[0], e.moved[1])));
  if (r.target_reached) return list;
  list.push_back("the target was missed: " + std::to_string(r.after.above_target) +
                 " tetrahedra have an AMIPS energy above " + number(a.options.target_amips) +
                 ", the greatest is " + number(r.after.max_amips));
  if (r.least_max_amips > a.options.target_amips)
    list.push_back("no mesh of this surface has a max AMIPS below " + number(r.least_max_amips) +
                   ", because of its angle at " + place(r.least_max_amips_at));
  for (const ImproveObstacle& o : r.obstacles)
    list.push_back(std::to_string(o.tets) + " of them: " + o.reason + "; max " + number(o.max_amips) +
                   " near " + place(o.example));
  return list;
}

/// One line on stderr that is overwritten repeatedly; nothing if stderr is not a terminal, unless requested.
void show_progress(ImproveArguments& a) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  if (!terminal && !a.progress) return;
  a.options.progress = [terminal](const ImproveProgress& p) {
    std::cerr << (terminal ? "\r" : "") << "pass " << p.pass << ": " << p.tets << " tetrahedra, "
              << p.above_target << " above the target, " << static_cast<long>(p.seconds) << " s"
              << (terminal ? "   " : "\n") << std::flush;
  };
}

/// The surface of the material, the interfaces and what else is listed.
std::vector<Confinement> in_envelope(PeriodicDomain& domain, double distance) {
  std::vector<Confinement> confined;
  for (const std::optional<NodeId> surface : {domain.add_surface(), domain.listed(2)})
    if (surface) confined.push_back({*surface, Confined::envelope, distance});
  return confined;
}

void run_on_tile(const ImproveArguments& a, RunReport& report, const std::string& note = {}) {
  check_tile_outputs(a.input, a.output, a.format, a.periodic);
  auto [file, domain] = read_periodic(a.input, a.periodic);
  if (domain.tree().mesh(domain.tile()).dimension() != 3)
    throw InputError(a.input + ": has no tetrahedron; remesh --periodic is for tiles of triangles");
  const TileSides sides = requested_sides(a.periodic).value_or(TileSides::flat);
  ImproveOptions options = a.options;
  const double envelope =
      a.relative_envelope > 0 ? a.relative_envelope * domain.diagonal() : a.options.envelope;
  if (envelope > 0) options.confined = in_envelope(domain, envelope);
  if (a.options.lock_surface) options.confined = fixed_walls(domain);
  const TileTopology before = topology_of(domain);
  std::optional<TilePage> page;
  if (report.wants_page()) page.emplace(domain);
  Json tile_before, tile_after;
  if (report.wanted()) tile_before = tools::to_json(domain, before);
  const ImproveResult r =
      io::naming(a.input, [&] { return improve(domain.embedding(sides), domain.tile(), options); });
  const double sizes = envelope > 0 ? options.keep_volume : 1e-9;
  const TileTopology after = topology_of(domain);
  add(write_tile_outputs(a.output, before, after, domain, file, a.format.options(), sizes, a.periodic),
      file.warnings);
  for (const std::string& reason : reasons(a, r)) file.warnings.push_back(reason);
  if (!note.empty()) file.warnings.push_back(note);
  report.json() = to_json(a, r);
  if (report.wanted()) tile_after = tools::to_json(domain, after);
  report.json()["periodic"] = {{"sides", name_of(sides)}, {"before", tile_before}, {"after", tile_after}};
  if (page) page->show(report, domain, a.input, a.output);
  if (!report.is_printed()) print(a, r);
  report.finish(file.warnings);
}

/// A file that says itself what is periodic, if nothing is requested that a tile does not have.
void run_on_declared_tile(ImproveArguments a, RunReport& report, const files::PeriodicMeshError& declared) {
  if (!a.options.locked_regions.empty() || !a.locked_patches.empty() || a.taken.weld) throw declared;
  a.periodic.axes = "xyz";
  try {
    run_on_tile(a, report,
                "the file declares the mesh periodic ($Periodic): it was improved as with --periodic xyz; "
                "--no-periodic takes it as any other mesh");
  } catch (const InputError& e) {
    throw InputError(std::string(declared.what()) + ". As a tile: " + e.what());
  }
}

void run(ImproveArguments a, RunReport& report) {
  show_progress(a);
  a.set_splits();
  if (a.feature_angle > 0) a.periodic.feature_angle = a.feature_angle;
  if (a.periodic.is_given()) return run_on_tile(a, report);
  check_output_path(a.output, {a.input}, a.format);
  files::DomainFile file;
  try {
    file = files::read_domain(a.input, a.taken);
  } catch (const files::PeriodicMeshError& e) {
    return run_on_declared_tile(a, report, e);
  }
  a.options.locked_regions = files::tags_of_groups(file, 3, a.options.locked_regions, "--lock-region");
  TetDomainOptions options;
  if (a.feature_angle > 0) options.feature_angle = a.feature_angle * std::numbers::pi / 180;
  a.options.locked_patches = files::tags_of_patches(file, a.locked_patches, "--lock-patch");
  TetDomain domain = files::take_domain(file, options);
  if (a.relative_envelope > 0)
    a.options.envelope = a.relative_envelope * bounding_box_diagonal(domain.points().values);
  const TetTopology before = topology_of(domain.tagged());
  HtmlMesh page;
  if (report.wants_page()) page = html_mesh(domain);
  const ImproveResult r = io::naming(a.input, [&] { return improve(domain, a.options); });
  const files::DomainWriteOptions how{a.format.options(), {false, a.feature_angle > 0, false}};
  add(write_if_same_mesh(a.output, before, DomainResult(domain), file.groups(), how, a.options.envelope),
      file.warnings);
  for (const std::string& reason : reasons(a, r)) file.warnings.push_back(reason);
  report.json() = to_json(a, r);
  if (report.wants_page()) show_domains(report, std::move(page), domain, a.input, a.output);
  if (!report.is_printed()) print(a, r);
  report.finish(file.warnings);
}

}  // namespace

void add_improve_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("improve", "Improve the shape of tetrahedra; surfaces and curves stay.");
  auto a = std::make_shared<ImproveArguments>();
  command->add_option("IN", a->input, std::string("tetrahedra: ") + files::simplex_formats)->required();
  command->add_option("-o,--output", a->output, files::written_simplex_formats)->required();
  command
      ->add_option(
          "--target-amips", a->options.target_amips,
          "worst energy to reach: 3 is the regular tetrahedron, 10 has dihedral angles above 6.6 degrees")
      ->check(CLI::Range(3.0, 1e9))
      ->capture_default_str()
      ->group("Targets");
  command
      ->add_option("--max-passes", a->options.max_passes,
                   "limit of passes over the tetrahedra above the target")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command
      ->add_option("--edge-length", a->options.edge_length,
                   "split edges above 4/3 of this, collapse edges below 4/5 of it where the surface allows")
      ->check(positive_number())
      ->group("Targets");
  command
      ->add_option("--max-edge-length", a->options.max_edge_length,
                   "split edges longer than this, and make none")
      ->check(positive_number())
      ->group("Targets");
  command
      ->add_option("--min-edge-length", a->options.min_edge_length,
                   "split no edge into edges shorter than this")
      ->check(positive_number());
  command
      ->add_option("--surface-splits", a->splits,
                   "split edges of the surface: not at all, exactly, or up to rounding")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(split_names), std::end(split_names))))
      ->capture_default_str();
  auto* envelope = command->add_option(
      "--envelope", a->options.envelope,
      "the surface, between regions too, may move by at most this, and leaves nothing farther behind");
  envelope->check(positive_number());
  command
      ->add_option("--relative-envelope", a->relative_envelope,
                   "the same, relative to the diagonal of the bounding box")
      ->check(positive_number())
      ->excludes(envelope);
  command
      ->add_option("--keep-volume", a->options.keep_volume,
                   "in an envelope: the volume of a region changes by at most this share of it")
      ->check(positive_number())
      ->capture_default_str();
  command
      ->add_option("--feature-angle", a->feature_angle,
                   "edges at which the surface bends by at least this become curves; degrees in (0, 180)")
      ->check(CLI::Range(1e-6, 180.0));
  command->add_option("--lock-region", a->options.locked_regions,
                      "regions to leave unchanged, by their tags");
  command->add_option("--lock-patch", a->locked_patches,
                      "patches whose triangles stay unchanged, by tags or names");
  command->add_flag("--lock-surface", a->options.lock_surface,
                    "all triangles of the surface and between regions stay unchanged");
  command->add_option("--time-limit", a->options.time_limit, "seconds; then the best mesh so far is written")
      ->check(positive_number());
  command
      ->add_option(
          "--max-growth", a->options.max_growth,
          "no edge is split for quality once the mesh has this many times its tetrahedra (at least 500)")
      ->check(CLI::Range(1.0, 1e9))
      ->capture_default_str();
  command->add_flag("--progress", a->progress, "show progress on stderr, even if it is not a terminal");
  add_weld_options(*command, a->taken);
  add_periodic_option(*command, a->taken.no_periodic);
  add_format_options(*command, a->format);
  add_report_options(*command, a->report, "with the surfaces in 3D, before and after, and the numbers");
  add_old_json_file(*command, a->report);
  auto* periodic = add_periodic_tile_options(*command, a->periodic);
  add_tile_output_options(*command, a->periodic);
  for (const char* other : {"--lock-region", "--lock-patch", "--weld", "--no-weld", "--no-periodic"})
    periodic->excludes(command->get_option(other));
  command->footer(
      "Example:  multimesh improve in.msh -o out.msh --target-amips 8 --report report.json\n"
      "          multimesh improve rve.msh -o out.msh --periodic xyz --pair-table pairs.csv\n\n"
      "The boundary, faces between regions and listed triangles and edges stay what they are; with\n"
      "--envelope they move within it, but for curves, and for places where they are no surface. If the\n"
      "target cannot be reached, the result is still written, warnings say why, and the exit status\n"
      "is 0. Elements keep their tags, groups and MEDIT's flags. What the input does not list is not\n"
      "added, except curves with --feature-angle. Before it is written, the result is compared with\n"
      "the input: if they differ after their parts are joined, the result is kept under another name\n"
      "and the exit status is 1.");
  command->callback([a, command, &exit_code] {
    RunReport report(*command, a->report, {a->input}, {a->output});
    run(*a, report);
    exit_code = done;
  });
}

#else

void add_improve_command(CLI::App& app, int&) {
  auto* command =
      app.add_subcommand("improve", "Not in this build: configure with -DMULTIMESH_BUILD_IMPROVE=ON.");
  command->allow_extras();
  command->callback(
      [] { throw InputError("improve: this build is one without it (-DMULTIMESH_BUILD_IMPROVE=ON)"); });
}

#endif

}  // namespace multimesh::tools
