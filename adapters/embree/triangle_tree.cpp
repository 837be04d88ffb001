// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/spatial/triangle_tree.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>

#include "adapters/embree/pieces.hpp"
#include "multimesh/error.hpp"
#include "multimesh/geometry/box_tree.hpp"

namespace multimesh::spatial {

namespace {

struct Release {
  void operator()(RTCDevice d) const { rtcReleaseDevice(d); }
  void operator()(RTCScene s) const { rtcReleaseScene(s); }
  void operator()(RTCGeometry g) const { rtcReleaseGeometry(g); }
};
using Device = std::unique_ptr<RTCDeviceTy, Release>;
using Scene = std::unique_ptr<RTCSceneTy, Release>;
using Geometry = std::unique_ptr<RTCGeometryTy, Release>;

/// Embree reports errors by a code.
void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error("Embree: error " + std::to_string(error));
}

bool finite(const Vec3& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// Embree gets coordinates that are translated and scaled so that all triangles lie in [-1, 1]^3. There a
// float has an error of at most 6e-8, as have Embree's own differences, and every bound below has room for
// many of these. For a point far outside, the error grows with its coordinates. Where the error could hide
// whole triangles, a tree in double precision is used, which takes twice the time: beyond `far`, and always
// if more than `most_tiny` triangles are smaller than `tiny`, for instance because others are far away.
constexpr double float_error = 1e-6;
constexpr double far = 100;
constexpr double tiny = 20 * float_error;
constexpr std::size_t most_tiny = 1000;

struct Frame {
  Vec3 center{};
  double scale = 1;  ///< from lengths of the triangles to Embree's

  explicit Frame(const std::vector<Triangle>& triangles) {
    if (triangles.empty()) return;
    Vec3 low = triangles[0][0], high = low;
    for (const Triangle& t : triangles)
      for (const Vec3& p : t)
        for (std::size_t i = 0; i < 3; ++i)
          low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
    double half = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      center[i] = low[i] / 2 + high[i] / 2;
      half = std::max(half, high[i] / 2 - low[i] / 2);
    }
    if (std::isnormal(1 / half) && half > 0) scale = 1 / half;
  }
  double to(double x, std::size_t axis) const { return (x - center[axis]) * scale; }
};

/// The longest side of the box around a triangle.
double size_of(const Triangle& t) {
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [least, most] = std::minmax({t[0][i], t[1][i], t[2][i]});
    size = std::max(size, most - least);
  }
  return size;
}

/// A radius that certainly reaches as far as `distance`, for a query whose largest coordinate is `size`.
float reach(double distance, double size) {
  return static_cast<float>(distance * (1 + float_error) + (1 + size) * float_error);
}

}  // namespace

struct TriangleTree::Data {
  std::vector<Triangle> triangles;
  std::vector<Index> facet_of;  ///< per piece in Embree's tree
  Frame frame;
  Device device;
  Scene scene;

  bool hides_triangles = false;  ///< the single-precision frame could hide triangles
  mutable std::once_flag double_boxes_made;
  mutable std::optional<BoxTree> double_boxes;

  explicit Data(std::vector<Triangle> t) : triangles(std::move(t)), frame(triangles) {}
  void build();
  /// Built on first use.
  const BoxTree& in_double_precision() const;

  /// Calls visit(facet) for all facets that may be within the radius. visit returns the radius, which may
  /// shrink. Some facets are visited several times.
  template <class Visit>
  void traverse(const Vec3& p, double radius, Visit visit) const;

  template <class Choice>
  std::optional<Nearby> nearest(const Vec3& p, double max_distance, Choice choose) const;
};

namespace {

struct Boxes {
  const std::vector<Piece>& pieces;
  const Frame& frame;

  static void bounds(const RTCBoundsFunctionArguments* arguments) {
    const auto& [pieces, frame] = *static_cast<const Boxes*>(arguments->geometryUserPtr);
    const Triangle& t = pieces[arguments->primID].triangle;
    std::array<float, 3> low{}, high{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [least, most] = std::minmax({t[0][i], t[1][i], t[2][i]});
      low[i] = static_cast<float>(frame.to(least, i) - float_error);
      high[i] = static_cast<float>(frame.to(most, i) + float_error);
    }
    RTCBounds& b = *arguments->bounds_o;
    b.lower_x = low[0], b.lower_y = low[1], b.lower_z = low[2];
    b.upper_x = high[0], b.upper_y = high[1], b.upper_z = high[2];
  }
};

}  // namespace

const BoxTree& TriangleTree::Data::in_double_precision() const {
  std::call_once(double_boxes_made, [this] { double_boxes.emplace(triangles); });
  return *double_boxes;
}

void TriangleTree::Data::build() {
  if (triangles.size() >= no_index) throw InputError("too many triangles: at most 2^32 - 2");
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (!std::all_of(triangles[t].begin(), triangles[t].end(), finite))
      throw InputError("triangle " + std::to_string(t) + ": a coordinate is not finite");
  const auto is_tiny = [&](const Triangle& t) { return size_of(t) * frame.scale < tiny; };
  hides_triangles =
      static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), is_tiny)) > most_tiny;
  if (hides_triangles) return;
  const std::vector<Piece> all = pieces(triangles);
  facet_of.reserve(all.size());
  for (const Piece& p : all) facet_of.push_back(p.facet);
  Boxes boxes{all, frame};
  device.reset(rtcNewDevice(nullptr));
  check(device.get());
  scene.reset(rtcNewScene(device.get()));
  const Geometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(all.size()));
  rtcSetGeometryUserData(geometry.get(), &boxes);
  rtcSetGeometryBoundsFunction(geometry.get(), &Boxes::bounds, nullptr);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene.get(), geometry.get());
  rtcCommitScene(scene.get());
  check(device.get());
}

template <class Visit>
void TriangleTree::Data::traverse(const Vec3& p, double radius, Visit visit) const {
  if (!finite(p)) throw UsageError("TriangleTree: the point is not finite");
  if (triangles.empty() || !(radius >= 0)) return;
  std::array<double, 3> at{};
  for (std::size_t i = 0; i < 3; ++i) at[i] = frame.to(p[i], i);
  const double size = std::max({std::abs(at[0]), std::abs(at[1]), std::abs(at[2])});
  if (hides_triangles || !(size < far)) {
    const auto squared = [&](Index facet) {
      const double now = visit(facet);
      return now * now;
    };
    return in_double_precision().visit_near(p, radius * radius, squared);
  }
  struct State {
    Visit& visit;
    const std::vector<Index>& facet_of;
    double scale, size;
  } state{visit, facet_of, frame.scale, size};
  RTCPointQuery query{};
  query.x = static_cast<float>(at[0]), query.y = static_cast<float>(at[1]);
  query.z = static_cast<float>(at[2]);
  query.radius = reach(radius * frame.scale, size);
  RTCPointQueryContext context{};
  rtcInitPointQueryContext(&context);
  const auto visit_one = [](RTCPointQueryFunctionArguments* arguments) {
    auto& s = *static_cast<State*>(arguments->userPtr);
    const float now = reach(s.visit(s.facet_of[arguments->primID]) * s.scale, s.size);
    if (!(now < arguments->query->radius)) return false;
    arguments->query->radius = now;
    return true;
  };
  rtcPointQuery(scene.get(), &query, &context, visit_one, &state);
}

TriangleTree::TriangleTree(std::vector<Triangle> triangles)
    : data_(std::make_unique<Data>(std::move(triangles))) {
  data_->build();
}

TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

const std::vector<Triangle>& TriangleTree::triangles() const {
  return data_->triangles;
}

// The order of visits is Embree's, but does not matter: the least pair of distance and facet is kept.
template <class Choice>
std::optional<Nearby> TriangleTree::Data::nearest(const Vec3& p, double max_distance, Choice choose) const {
  Nearby best;
  best.squared_distance = max_distance * max_distance;
  double radius = max_distance;
  traverse(p, max_distance, [&](Index facet) {
    const std::optional<PointOnTriangle> q = choose(facet);
    if (q && (q->squared_distance < best.squared_distance ||
              (q->squared_distance == best.squared_distance && facet < best.facet))) {
      best = {facet, q->barycentric, q->squared_distance};
      radius = std::sqrt(q->squared_distance);
    }
    return radius;
  });
  if (best.facet == no_index) return std::nullopt;
  return best;
}

std::optional<Nearby> TriangleTree::nearest(const Vec3& p, double max_distance) const {
  return data_->nearest(
      p, max_distance, [&](Index facet) { return std::optional(closest_point(p, data_->triangles[facet])); });
}

bool TriangleTree::has_within(const Vec3& p, double max_distance) const {
  bool found = false;
  data_->traverse(p, max_distance, [&](Index facet) {
    found =
        found || closest_point(p, data_->triangles[facet]).squared_distance <= max_distance * max_distance;
    return found ? 0 : max_distance;
  });
  return found;
}

std::optional<Nearby> TriangleTree::nearest_chosen(const Vec3& p, const Choose& choose,
                                                   double max_distance) const {
  return data_->nearest(p, max_distance, std::cref(choose));
}

void TriangleTree::within(const Vec3& p, double radius, std::vector<Nearby>& found) const {
  found.clear();
  data_->traverse(p, radius, [&](Index facet) {
    const PointOnTriangle q = closest_point(p, data_->triangles[facet]);
    if (q.squared_distance <= radius * radius) found.push_back({facet, q.barycentric, q.squared_distance});
    return radius;
  });
  std::sort(found.begin(), found.end(), [](const Nearby& a, const Nearby& b) { return a.facet < b.facet; });
  const auto same = [](const Nearby& a, const Nearby& b) { return a.facet == b.facet; };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
}

}  // namespace multimesh::spatial
