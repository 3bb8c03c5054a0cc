#include "tools/export/model_files.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aspect {
namespace {

Direction3 direction_of(const ObservedView& view) {
  return {view.direction.x(), view.direction.y(), view.direction.z()};
}

ListedVertex listed(const StoredModel& model, VertexId vertex) {
  const ObservedView& view = model.subdivision.views[number(vertex)];
  return {direction_of(view), static_cast<std::int64_t>(number(vertex)) + 1,
          static_cast<std::int64_t>(view.external_count)};
}

// In order as it is read, not as it was before it was rounded.
std::array<std::int64_t, 3> written_place(const ListedVertex& vertex) {
  std::array<std::int64_t, 3> place{};
  for (std::size_t k = 0; k < 3; ++k) place[k] = std::llround(vertex.direction[k] * 1e10);
  return place;
}

ListedPatch listed(const StoredModel& model, PatchId id) {
  const Patch& patch = model.subdivision.sphere.patch(id);
  ListedPatch out;
  for (std::size_t k = 0; k < 3; ++k) out.corners[k] = listed(model, patch.corners[k]);
  out.level = patch.level;
  return out;
}

std::vector<GraphNode> named_nodes(const ObservedView& view, const ClusterView& in_cluster,
                                   const std::vector<AttributeVector>& attributes) {
  std::vector<GraphNode> nodes(view.external_count);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::size_t name = in_cluster.names[i];
    nodes[name] = {name_of_place(name), "na", true, view.contours[i].shape, attributes[i]};
  }
  return nodes;
}

// Sums of attributes, a type each; and what is nearest to the type, for those without any.
struct TypeSum {
  std::array<double, kAttributes> sum{};
  double count = 0;
  AttributeVector nearest{};
  float distance = std::numeric_limits<float>::infinity();
};

AttributeVector mean_of(const TypeSum& type) {
  if (!(type.count > 0)) return type.nearest;
  AttributeVector mean{};
  for (std::size_t k = 0; k < kAttributes; ++k) mean[k] = std::llround(type.sum[k] / type.count);
  return mean;
}

void add_contour(const TypeAttributes& place, const AttributeVector& attributes,
                 std::span<const TypeAttributes> types, std::vector<TypeSum>& sums) {
  TypeSum& own = sums[nearest_type(types, place)];
  own.count += 1;
  for (std::size_t k = 0; k < kAttributes; ++k) own.sum[k] += static_cast<double>(attributes[k]);
  for (std::size_t t = 0; t < types.size(); ++t) {
    if (sums[t].count > 0) continue;
    const float distance = squared_type_distance(types[t], place);
    if (distance >= sums[t].distance) continue;
    sums[t].distance = distance;
    sums[t].nearest = attributes;
  }
}

ListedClass listed_class(const ClassDescription& description) {
  ListedClass out;
  for (const ContourDescription& contour : description.contours) {
    RegionTypes& types = out.emplace_back();
    for (const auto& [type, score] : contour.score_of_type)
      types.push_back({type, std::llround(score)});
  }
  return out;
}

}  // namespace

std::vector<std::string> view_names_of(const StoredModel& model) {
  std::vector<Direction3> directions;
  for (const ObservedView& view : model.subdivision.views) directions.push_back(direction_of(view));
  return view_names(directions);
}

std::vector<ListedVertex> vertices_of(const StoredModel& model) {
  std::vector<ListedVertex> vertices;
  for (std::size_t v = 0; v < model.subdivision.views.size(); ++v)
    vertices.push_back(listed(model, static_cast<VertexId>(v)));
  std::sort(vertices.begin(), vertices.end(), [](const ListedVertex& a, const ListedVertex& b) {
    const auto left = written_place(a), right = written_place(b);
    return left != right ? left < right : a.id < b.id;
  });
  return vertices;
}

std::vector<Partition> partitions_of(const StoredModel& model) {
  std::vector<Partition> partitions;
  for (const Cluster& cluster : model.clusters) {
    Partition& partition = partitions.emplace_back();
    for (const PatchId patch : cluster.patches) partition.push_back(listed(model, patch));
  }
  return partitions;
}

std::vector<DetailGroup> details_of(const StoredModel& model, std::span<const std::string> names,
                                    const ViewAttributes& attributes) {
  std::vector<DetailGroup> groups;
  std::int64_t id = 0;
  for (const Cluster& cluster : model.clusters) {
    DetailGroup& group = groups.emplace_back();
    for (const ClusterView& in_cluster : cluster.views) {
      const std::size_t v = number(in_cluster.vertex);
      const ObservedView& view = model.subdivision.views[v];
      const Angles angles = angles_of(direction_of(view));
      ++id;
      group.push_back({{id, id},
                       angles.theta_deg,
                       angles.phi_deg,
                       names[v],
                       named_nodes(view, in_cluster, attributes[v])});
    }
  }
  return groups;
}

std::vector<AttributeVector> means_of(const StoredModel& model, const ViewAttributes& attributes) {
  std::vector<TypeSum> sums(model.types.size());
  for (const Cluster& cluster : model.clusters) {
    for (const ClusterView& in_cluster : cluster.views) {
      const std::size_t v = number(in_cluster.vertex);
      const ObservedView& view = model.subdivision.views[v];
      for (std::size_t i = 0; i < view.external_count; ++i)
        add_contour(type_attributes(view.contours[i].feature), attributes[v][i], model.types, sums);
    }
  }
  std::vector<AttributeVector> means;
  for (const TypeSum& sum : sums) means.push_back(mean_of(sum));
  return means;
}

std::vector<ListedClass> classes_of(const StoredModel& model) {
  std::vector<ListedClass> classes;
  for (const Cluster& cluster : model.clusters)
    classes.push_back(
        listed_class(describe_class(model.subdivision, cluster, model.types, Scoring::views)));
  return classes;
}

}  // namespace aspect
