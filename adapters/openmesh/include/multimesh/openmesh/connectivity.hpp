// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "multimesh/mesh.hpp"
#include "multimesh/openmesh/attachment.hpp"
#include "multimesh/openmesh/watch.hpp"

namespace multimesh::openmesh {

/// The common part of the adapters for triangles, edges and points: an OpenMesh connectivity (the base of
/// every OpenMesh mesh, so one compiled class serves all traits), our properties on it, and a journal of
/// every word written.
///
/// The mesh stays the user's. We request vertex, edge and face status, and add properties whose names begin
/// with "mm:"; all of this is removed when the adapter is destroyed. Copies of the mesh are ordinary meshes,
/// which can be attached themselves. While attached, the mesh must not be moved, assigned or cleared. Edits
/// of its connectivity other than through the tree are detected (Watch), and followed where possible
/// (MultiMesh::resync).
class Connectivity : public Mesh {
 public:
  ~Connectivity() override;

  OpenMesh::PolyConnectivity& openmesh() noexcept { return om_; }
  const OpenMesh::PolyConnectivity& openmesh() const noexcept { return om_; }

  /// The user's status bit of that name.
  bool is_locked(Index v) const override { return (*vertex_status_)[v].locked(); }
  void set_locked(Index v, bool on) override { (*vertex_status_)[v].set_locked(on); }

  Mark mark() const override { return log_.size(); }
  void rollback(Mark mark) override;
  void forget() override;
  void protect(int k, Index s) override;

  // Properties of the user's (all but the status and our own): the mesh carries them through the operations
  // by fixed rules, whatever their type, unless they are left to somebody else.
  bool has_values(int k) const override;
  void keep(int k, std::unique_ptr<ValueList> values) override;
  void drop(int k, const void* values) override;
  /// From now on, as long as `still` says so, somebody else writes this property in operations, with a
  /// journal of its own.
  void leave(const OpenMesh::BaseProperty& property, std::function<bool()> still);
  bool is_left(const OpenMesh::BaseProperty& property) const;

  void add_anchors() override;
  void remove_anchors() override;
  Anchor anchor(Index f) const override { return (*anchors_)[f]; }
  void set_anchor(Index f, Anchor a) override;
  LinkSet add_links(int k) override;
  void remove_links(LinkSet links) override;
  Index link(LinkSet links, Dart d) const override {
    const Links& l = links_[links];
    return (*l.facet_plus_one)[simplex(d, l.k)] - 1;
  }
  void set_link(LinkSet links, Dart d, Index f) override;
  void remap_links(LinkSet links, const std::vector<Index>& child_facets) override;
  Compaction compact() override;

  bool same_counts() const override { return !watch_ || watch_->same_counts(); }
  bool star_in_step(Index v) const override { return !watch_ || watch_->in_step(static_cast<int>(v)); }
  std::optional<Index> first_out_of_step() const override;
  std::optional<Compaction> renumbering() const override;
  void accept_edits() override;

 protected:
  Connectivity(int dimension, OpenMesh::PolyConnectivity& om);
  /// From now on, other code may edit the mesh, too.
  void watch();
  /// \throw InputError with the first problem of check(). Cost: linear
  void require_consistent() const;
  /// \throw InputError naming two simplices with the same vertices. Cost: sorting
  void require_proper() const;
  /// Owns a mesh that was made for this adapter.
  void own(std::unique_ptr<OpenMesh::PolyConnectivity> om) noexcept { owned_ = std::move(om); }

  // OpenMesh's connectivity by plain indices; -1 is OpenMesh's own "none".
  int to(int h) const { return om_.to_vertex_handle(handle(h)).idx(); }
  int from(int h) const { return to(h ^ 1); }
  int next(int h) const { return om_.next_halfedge_handle(handle(h)).idx(); }
  int prev(int h) const { return om_.prev_halfedge_handle(handle(h)).idx(); }
  int face(int h) const { return om_.face_handle(handle(h)).idx(); }
  int out(int v) const { return om_.halfedge_handle(OpenMesh::VertexHandle(v)).idx(); }
  int halfedge_of(int f) const { return om_.halfedge_handle(OpenMesh::FaceHandle(f)).idx(); }
  static OpenMesh::HalfedgeHandle handle(int h) { return OpenMesh::HalfedgeHandle(h); }

  // The same for writing; each write is journaled.
  void set_to(int h, int v);
  void set_next(int h, int n);  // and prev of n
  void set_face(int h, int f);
  void set_out(int v, int h);
  void set_halfedge_of(int f, int h);
  void kill_vertex(int v);
  void kill_edge(int e);
  void kill_face(int f);

  int new_vertex();
  int new_edge(int from, int to);  // its even halfedge
  int new_face();
  void copy_edge_properties(int from_halfedge, int to_halfedge);    // and those of both halfedges
  void copy_corner_properties(int from_halfedge, int to_halfedge);  // of these halfedges alone
  void copy_face_properties(int from, int to);
  /// The kinds of properties that are carried through operations.
  struct Carried {
    bool by_edges, by_halfedges;
  };
  Carried what_is_carried() const;
  // Exchanged with those of an element that dies, so that they can be restored.
  void exchange_edge_values(int kept, int dying);
  void exchange_halfedge_values(int kept, int dying);
  /// The edge gets the values of a new one, its halfedges those of two others.
  void renew_edge(int halfedge, int like, int opposite_like);
  /// Adds the flags of another edge.
  void unite_edge_flags(int kept, int other);

  /// Per simplex, the facet of the child over it, plus one; 0: none.
  const std::vector<Index>& link_column(LinkSet links) const { return *links_[links].facet_plus_one; }

  using Status = std::vector<OpenMesh::Attributes::StatusInfo>;
  const Status& status(int k) const {
    return *(k == 0 ? vertex_status_ : k == 1 ? edge_status_ : face_status_);
  }

  OpenMesh::PolyConnectivity& om_;

 private:
  enum class Word : std::uint8_t {
    to,
    next,
    prev,
    face,
    out,
    halfedge_of,
    vertex_status,
    edge_status,
    face_status,
    anchor_own,
    anchor_parent,
    link,
    vertices,
    edges,
    faces,  // counts
    spare,
    edge_values,
    halfedge_values,
    renewed,
  };
  struct Entry {
    Word word;
    LinkSet column;
    std::uint32_t index;
    std::uint32_t old;
  };
  /// A stack. Every write goes through push(), so it grows out of line.
  class Journal {
   public:
    std::size_t size() const noexcept { return static_cast<std::size_t>(end_ - entries_.data()); }
    bool empty() const noexcept { return end_ == entries_.data(); }
    const Entry& back() const { return end_[-1]; }
    void push(const Entry& e) {
      if (end_ == limit_) [[unlikely]]
        grow();
      *end_++ = e;
    }
    void pop() noexcept { --end_; }
    void clear() noexcept { end_ = entries_.data(); }

   private:
    void grow();
    std::vector<Entry> entries_;
    Entry* end_ = entries_.data();
    const Entry* limit_ = end_;
  };
  struct Links {
    int k = 0;
    OpenMesh::VPropHandleT<Index> vertices;
    OpenMesh::EPropHandleT<Index> edges;
    OpenMesh::FPropHandleT<Index> faces;
    std::vector<Index>* facet_plus_one = nullptr;  // 0: no facet (new slots are zero-filled)
    bool used = false;
  };

  void log(Word word, std::uint32_t index, std::uint32_t old, LinkSet column = 0) {
    log_.push({word, column, index, old});
  }
  void log_counts();
  int named(int k, int element);
  void write_to(int h, int v);
  void write_face(int h, int f);
  void write_edge_status(std::uint32_t e, unsigned bits);
  void pop(std::size_t vertices, std::size_t edges, std::size_t faces);
  void set_dart_blocks(Compaction& moved) const;
  void undo(const Entry& e);
  void copy_properties(int k, std::size_t from, std::size_t to);
  bool is_carried(const OpenMesh::BaseProperty& property) const;
  template <class Visit>
  void for_each_edge_property(const Visit& visit) const;
  template <class Visit>
  void for_each_halfedge_property(const Visit& visit) const;
  void exchange(const Entry& e);
  int make_spare(int k);
  template <class Visit>
  void with_anchor_property(const Visit& visit);

  struct Left {
    const OpenMesh::BaseProperty* property;
    std::function<bool()> still;
  };
  std::vector<Left> left_;
  void find_data_of_default_traits();
  /// What OpenMesh's default traits store at each edge and halfedge: nothing.
  const OpenMesh::BaseProperty* no_data_[2] = {nullptr, nullptr};

  std::unique_ptr<OpenMesh::PolyConnectivity> owned_;
  Attachment attachment_;
  Journal log_;
  // Dead elements that hold the protected properties of live ones: OpenMesh's property base class can copy
  // only between elements of one mesh.
  std::vector<int> spares_[3];
  Status* vertex_status_ = nullptr;
  Status* edge_status_ = nullptr;
  Status* face_status_ = nullptr;
  OpenMesh::VPropHandleT<Anchor> vertex_anchors_;
  OpenMesh::EPropHandleT<Anchor> edge_anchors_;
  OpenMesh::FPropHandleT<Anchor> face_anchors_;
  std::vector<Anchor>* anchors_ = nullptr;
  std::vector<Links> links_;
  std::unique_ptr<Watch> watch_;  // if the mesh is a user's
};

}  // namespace multimesh::openmesh
