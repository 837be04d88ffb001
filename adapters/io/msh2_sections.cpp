// SPDX-License-Identifier: BSD-3-Clause
// The sections of Gmsh's format 2.2.
#include <array>
#include <vector>

#include "adapters/io/msh_content.hpp"

namespace multimesh::io {
namespace {

std::uint64_t node_number(MshContent& content) {
  const std::int32_t number = content.in.integer("the number of a node");
  if (number < 0) content.in.fail("node number " + std::to_string(number) + " is negative; correct it");
  return static_cast<std::uint64_t>(number);
}

/// One element: `number tags… nodes…`, with the number of tags known.
class ElementReader {
 public:
  explicit ElementReader(MshContent& content) : content_(content) {}

  void text() {
    MshSource& in = content_.in;
    const std::int32_t number = in.integer("the number of an element");
    const CellType& type = content_.element_type(in.integer("the type of an element"), in.where(0));
    const std::size_t tags = tag_count(in.integer("the number of tags of an element"));
    element(type, tags, number);
  }

  /// A block of elements of one type. \return how many there were
  std::size_t binary_block(std::size_t left) {
    MshSource& in = content_.in;
    const std::int32_t type_number = in.integer("the type of elements");
    const std::int32_t count = in.integer("the number of elements of a type");
    const std::size_t tags = tag_count(in.integer("the number of tags of elements"));
    if (count <= 0 || static_cast<std::size_t>(count) > left)
      in.fail(std::to_string(count) + " elements of a type are announced where " + std::to_string(left) +
              " are left; the file is damaged, save it again");
    const CellType& type = content_.element_type(type_number, 0);
    in.words().check_count(static_cast<std::uint64_t>(count), "elements", 4 * (1 + tags + type.nodes));
    for (std::int32_t i = 0; i < count; ++i) element(type, tags, in.integer("the number of an element"));
    return static_cast<std::size_t>(count);
  }

 private:
  std::size_t tag_count(std::int32_t count) const {
    if (count < 0 || count > 1000)
      content_.in.fail(std::to_string(count) + " tags of an element are not possible; correct it");
    return static_cast<std::size_t>(count);
  }

  /// The first tag is the physical one, the second the entity; the others are partitions.
  void element(const CellType& type, std::size_t tags, std::int32_t number) {
    MshSource& in = content_.in;
    if (tags > 2) content_.has_partitions = true;
    std::array<std::int32_t, 2> kept{};
    for (std::size_t i = 0; i < tags; ++i) {
      const std::int32_t tag = in.integer("a tag of an element");
      if (i < 2) kept[i] = tag;
    }
    const std::uint64_t where = in.where(static_cast<std::uint32_t>(number));
    nodes_.clear();
    for (int i = 0; i < type.nodes; ++i) nodes_.push_back(content_.point(node_number(content_), where));
    content_.add_element(type, nodes_, kept[0], kept[1], where);
  }

  MshContent& content_;
  std::vector<std::uint32_t> nodes_;
};

/// `Affine` and 16 numbers, which may be missing.
std::vector<double> affine(WordSource& words) {
  std::vector<double> matrix;
  if (words.peek() != "Affine") return matrix;
  words.word("Affine");
  for (int i = 0; i < 16; ++i) matrix.push_back(words.number("an affine map"));
  return matrix;
}

}  // namespace

namespace {

/// `after(in)` reads what follows the coordinates.
template <class After>
void read_nodes(MshContent& content, const After& after) {
  MshSource& in = content.in;
  const std::size_t count = in.words().count("nodes", in.binary() ? 28 : 8);
  in.begin_data();
  content.out.reserve_points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t number = node_number(content);
    std::array<double, 3> point{};
    for (double& x : point) x = in.real("a coordinate");
    after(in);
    content.add_point(number, point, in.where(number));
  }
}

}  // namespace

void read_msh2_nodes(MshContent& content) {
  read_nodes(content, [](MshSource&) {});
}

/// After each node come its entity and its parameters on that, which we do not use.
void read_msh2_parametric_nodes(MshContent& content) {
  read_nodes(content, [](MshSource& in) {
    const std::int32_t dimension = in.integer("the dimension of an entity");
    in.integer("the tag of an entity");
    if (dimension != 1 && dimension != 2) return;
    for (std::int32_t i = 0; i < dimension; ++i) in.real("a parametric coordinate");
  });
}

void read_msh2_elements(MshContent& content) {
  MshSource& in = content.in;
  const std::size_t count = in.words().count("elements", 8);
  in.begin_data();
  ElementReader reader(content);
  for (std::size_t done = 0; done < count;) {
    if (in.binary()) {
      done += reader.binary_block(count - done);
    } else {
      reader.text();
      ++done;
    }
  }
}

/// Text, also in binary files.
void read_msh2_periodic(MshContent& content) {
  WordSource& words = content.in.words();
  for (std::size_t n = words.count("periodic entities", 6); n > 0; --n) {
    SimplexSoup::Periodic link;
    link.dimension = words.integer32("the dimension of a periodic entity");
    if (link.dimension < 0 || link.dimension > 3)
      words.fail("the dimension of a periodic entity must be 0 to 3");
    link.slave = words.integer32("the tag of a periodic entity");
    link.master = words.integer32("the tag of a master entity");
    link.affine = affine(words);
    const std::size_t pairs = words.count("periodic nodes", 4);
    for (std::size_t i = 0; i < pairs; ++i) {
      std::array<std::uint32_t, 2> pair{};
      for (std::uint32_t& point : pair)
        point = content.point(static_cast<std::uint64_t>(words.integer("a periodic node")), words.line());
      link.points.push_back(pair);
    }
    content.out.soup().periodic.push_back(std::move(link));
  }
}

}  // namespace multimesh::io
