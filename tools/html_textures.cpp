// SPDX-License-Identifier: BSD-3-Clause
#include "tools/html_textures.hpp"

#include <system_error>

#include "tools/image_data_uri.hpp"

namespace multimesh::tools {

std::size_t HtmlTextures::number(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path canonical = std::filesystem::weakly_canonical(file, error);
  if (error) canonical = file;
  const auto [at, is_new] = numbers_.try_emplace(std::move(canonical), uris_.size());
  if (!is_new) return at->second;
  ImageDataUri image = image_data_uri(file);
  if (size_ + image.uri.size() > limit_) {
    image = {
        {},
        "with it the textures of this page would be larger than " + std::to_string(limit_ >> 20U) + " MiB"};
  }
  size_ += image.uri.size();
  const std::string name = file.filename().string();
  if (!image.problem.empty() && std::filesystem::exists(file, error))
    notes_.push_back("texture " + name + ": " + image.problem + "; a checker pattern is shown instead");
  names_.push_back({{"name", name}});
  uris_.push_back(std::move(image.uri));
  return at->second;
}

}  // namespace multimesh::tools
