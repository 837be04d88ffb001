// SPDX-License-Identifier: BSD-3-Clause
#include "tools/decimate_report.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "multimesh/version.hpp"

namespace multimesh::tools {

const char* to_string(DecimateResult::Stop stop) {
  switch (stop) {
    case DecimateResult::Stop::faces:
      return "target number of faces";
    case DecimateResult::Stop::bound:
      return "bounds on the result";
    case DecimateResult::Stop::exhausted:
      return "no edge left that may be collapsed";
  }
  return "?";
}

bool target_reached(const DecimateOptions& o, const DecimateResult& r) {
  return o.faces == 0 || r.stop == DecimateResult::Stop::faces;
}

void warn_of_target(const DecimateOptions& o, const DecimateResult& r, const char* faces,
                    std::vector<std::string>& warnings) {
  if (target_reached(o, r)) return;
  std::string text = "the target of " + std::to_string(o.faces) + ' ' + faces +
                     " cannot be reached. Edges left, by what keeps them:";
  for (const auto& [reason, count] : r.blocking) text += ' ' + reason + ' ' + std::to_string(count) + ';';
  warnings.push_back(text);
}

Json to_json(const TextureLoss& loss) {
  return {{"deviation", loss.at_end.deviation},
          {"outside_own_chart", loss.at_end.outside},
          {"bounds",
           {{"deviation", tolerable_texture.deviation}, {"outside_own_chart", tolerable_texture.outside}}},
          {"last_faces_within_bounds", loss.faces > 0 ? Json(loss.faces) : Json()}};
}

std::string in_words(const TextureLoss& loss, const DecimateResult& result) {
  const auto text = [](double number, int digits) {
    std::ostringstream out;
    out << std::setprecision(digits) << number;
    return out.str();
  };
  const auto percent = [&](double share) { return text(100 * share, 2) + " %"; };
  const auto both = [&](const TextureQuality& q) {
    return percent(q.deviation) + " of the diagonal (root mean square) and " + percent(q.outside) +
           " of the surface outside of its charts";
  };
  const std::string last = loss.faces == 0
                               ? "no number of faces on the way was"
                               : std::to_string(loss.faces) + " faces is the last number on the way that was";
  return "the texture is damaged: at " + std::to_string(result.faces_after) + " faces it deviates by " +
         both(loss.at_end) + "; " + last + " within " + both(tolerable_texture) +
         ". Stop there, or bound it, for instance by --max-texture-error " +
         text(std::min(tolerable_texture.deviation, 2 * loss.at_end.deviation), 1);
}

namespace {

Json counts(const std::vector<RefusalCount>& list) {
  Json j = Json::object();
  for (const auto& [reason, count] : list) j[reason] = count;
  return j;
}

Json options_json(const DecimateArguments& a, const DecimateOptions& o) {
  Json j{{"cost", a.cost}};
  if (o.faces > 0) j["target_faces"] = o.faces;
  if (!o.levels.empty()) j["levels"] = o.levels;
  if (a.max_error > 0) j["max_error"] = a.max_error;
  if (a.max_texture_error > 0) j["max_texture_error"] = a.max_texture_error;
  if (a.feature_angle > 0) j["feature_angle_degrees"] = a.feature_angle;
  if (a.normal_deviation > 0) j["normal_deviation_degrees"] = a.normal_deviation;
  if (a.aspect_ratio > 0) j["aspect_ratio"] = a.aspect_ratio;
  j["lock_boundary"] = a.lock_boundary;
  j["lock_seams"] = a.lock_seams;
  j["preserve_materials"] = a.preserve_materials;
  j["uv_weight"] = o.uv_weight;
  j["curve_weight"] = o.curve_weight;
  j["seam_weight"] = o.seam_weight;
  j["uv_curve_weight"] = o.uv_curve_weight;
  j["memory_weight"] = o.memory_weight;
  return j;
}

}  // namespace

Json decimation_json(const DecimateArguments& a, const DecimateOptions& o, const DecimateResult& r) {
  Json j;
  j["program"] = std::string("multimesh ") + version;
  j["input"] = a.input;
  j["output"] = a.output;
  j["options"] = options_json(a, o);
  j["faces"] = {{"before", r.faces_before}, {"after", r.faces_after}};
  j["target_reached"] = target_reached(o, r);
  j["stopped_by"] = to_string(r.stop);
  if (!r.blocking.empty()) j["edges_left_by_what_keeps_them"] = counts(r.blocking);
  j["collapses"] = {
      {"tried", r.tried}, {"done", r.collapsed}, {"refused", counts(r.refused)}, {"seconds", r.seconds}};
  j["max_cost"] = r.max_cost;
  return j;
}

}  // namespace multimesh::tools
