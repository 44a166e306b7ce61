/* SPDX-License-Identifier: MIT */
// A light tree as path tracers have it (Conty Estevez and Kulla 2018, "Importance Sampling of Many
// Lights with Adaptive Tree Splitting"): split top-down by the surface area orientation heuristic,
// with cones of axes, leaves of up to four lights, and lights drawn by importance, one of a cluster
// or one of each cluster of a cut. It is judged by bounds and cuts, too. The root has a child for
// each kind of light, all others have two. Wants light_group.h and shading.h beside it:
//
//   cc -shared -fPIC -std=c99 -O2 -I oracle/include top_down_tree.c -o libtop_down_tree.so -lm
//   lightcuts-oracle check desk --subject ./libtop_down_tree.so

#include <stdlib.h>
#include <string.h>

#include "light_group.h"

enum { most_lights = 4, most_parts = 4, bins = 12 };

// ---- the tree

typedef struct node {
  uint32_t child[most_parts];
  uint32_t children;     ///< 0: a leaf
  uint32_t parent;       ///< unused of the root
  uint32_t first, count; ///< of tree.order
  uint32_t brightest;    ///< light
  group all;
} node;

typedef struct tree {
  lightcuts_light* lights;
  node* nodes;
  uint32_t* order;   ///< lights, those of a node one after another
  uint32_t* leaf_of; ///< of each light
  uint32_t size;
  float min_distance;
} tree;

/// The cone's angle is measured in the end, so that roundings do not add up.
static void measure_node(const tree* t, node* n) {
  double most = -1;
  int joined = 0;
  for (uint32_t i = 0; i < n->count; ++i) {
    const uint32_t light = t->order[n->first + i];
    const group one = group_of(&t->lights[light]);
    add(&n->all, &joined, &one);
    if (power(&one) < most || (power(&one) == most && light > n->brightest)) continue;
    most = power(&one);
    n->brightest = light;
  }
  if (!has_axis(n->all.kind) || n->all.axes.angle == pi) return;
  n->all.axes.angle = 0;
  for (uint32_t i = 0; i < n->count; ++i) {
    const group one = group_of(&t->lights[t->order[n->first + i]]);
    n->all.axes.angle = fmax(n->all.axes.angle, angle_between(n->all.axes.axis, one.axes.axis));
  }
}

/// A plane between the bins of an axis.
typedef struct plane {
  int axis, bin;
  double cost;
} plane;

static int bin_of(const group* all, int axis, const lightcuts_light* light) {
  const double share = ((double)light->position[axis] - all->box.low[axis]) / extent(all, axis);
  return (int)fmin(share * bins, bins - 1);
}

/// Costs of what lies before and behind each plane across the axis.
static void compare(const tree* t, const node* n, int axis, double weight, plane* best) {
  group bin[bins], side = {0};
  int count[bins] = {0}, sum = 0;
  double behind[bins] = {0};
  for (uint32_t i = 0; i < n->count; ++i) {
    const lightcuts_light* light = &t->lights[t->order[n->first + i]];
    const int k = bin_of(&n->all, axis, light);
    const group one = group_of(light);
    add(&bin[k], &count[k], &one);
  }
  for (int k = bins - 1; k > 0; --k) {
    if (count[k] > 0) add(&side, &sum, &bin[k]);
    behind[k] = cost(&side);
  }
  sum = 0;
  for (int k = 1; k < bins; ++k) {
    if (count[k - 1] > 0) add(&side, &sum, &bin[k - 1]);
    const double total = weight * (cost(&side) + behind[k]);
    if (total < best->cost) *best = (plane){axis, k, total};
  }
}

/// Moves those before the best plane to the front, and returns how many they are.
static uint32_t split(tree* t, const node* n) {
  plane best = {0, 0, INFINITY};
  const group* all = &n->all;
  // Planes across the longest side cost less.
  const double longest = fmax(extent(all, 0), fmax(extent(all, 1), extent(all, 2)));
  for (int i = 0; i < 3; ++i)
    if (extent(all, i) > 0) compare(t, n, i, longest / extent(all, i), &best);
  if (best.bin == 0) return n->count / 2; // all at one place
  uint32_t front = 0;
  for (uint32_t i = 0; i < n->count; ++i) {
    uint32_t* at = &t->order[n->first + i];
    if (bin_of(all, best.axis, &t->lights[*at]) >= best.bin) continue;
    const uint32_t light = *at;
    *at = t->order[n->first + front];
    t->order[n->first + front++] = light;
  }
  return front;
}

/// How many lights each part has; at most one for each kind, which the lights are sorted by.
static uint32_t parts_of(tree* t, const node* n, uint32_t sizes[most_parts]) {
  if (n->all.kind != mixed) {
    sizes[0] = split(t, n);
    sizes[1] = n->count - sizes[0];
    return 2;
  }
  uint32_t parts = 0, kind = mixed;
  for (uint32_t i = 0; i < n->count; ++i) {
    const uint32_t own = t->lights[t->order[n->first + i]].kind;
    if (own != kind) sizes[parts++] = 0;
    ++sizes[parts - 1];
    kind = own;
  }
  return parts;
}

static uint32_t make_node(tree* t, uint32_t first, uint32_t count) {
  const uint32_t index = t->size++;
  node* n = &t->nodes[index];
  n->first = first;
  n->count = count;
  measure_node(t, n);
  if (n->all.kind != mixed && count <= most_lights) {
    for (uint32_t i = 0; i < count; ++i) t->leaf_of[t->order[first + i]] = index;
    return index;
  }
  uint32_t sizes[most_parts];
  n->children = parts_of(t, n, sizes);
  for (uint32_t k = 0; k < n->children; ++k) {
    n->child[k] = make_node(t, first, sizes[k]);
    t->nodes[n->child[k]].parent = index;
    first += sizes[k];
  }
  return index;
}

static void destroy(void* of) {
  tree* t = of;
  if (t == NULL) return;
  free(t->lights);
  free(t->nodes);
  free(t->order);
  free(t->leaf_of);
  free(t);
}

static void* build(const lightcuts_light* lights, uint32_t count, float min_distance,
                   uint64_t seed) {
  (void)seed; // nothing is random here
  tree* t = calloc(1, sizeof *t);
  if (t == NULL) return NULL;
  t->min_distance = min_distance;
  t->lights = calloc(count, sizeof *t->lights);
  t->nodes = calloc(2 * (size_t)count, sizeof *t->nodes);
  t->order = calloc(count, sizeof *t->order);
  t->leaf_of = calloc(count, sizeof *t->leaf_of);
  if (t->lights == NULL || t->nodes == NULL || t->order == NULL || t->leaf_of == NULL) {
    destroy(t);
    return NULL;
  }
  memcpy(t->lights, lights, count * sizeof *lights);
  for (uint32_t kind = 0, n = 0; kind < mixed; ++kind)
    for (uint32_t i = 0; i < count; ++i)
      if (lights[i].kind == kind) t->order[n++] = i;
  make_node(t, 0, count);
  return t;
}

static uint32_t node_count(void* of) { return ((tree*)of)->size; }

static uint32_t children(void* of, uint32_t index, uint32_t* out, uint32_t capacity) {
  const node* n = &((tree*)of)->nodes[index];
  for (uint32_t k = 0; k < n->children && k < capacity; ++k) out[k] = n->child[k];
  return n->children;
}

static uint32_t lights(void* of, uint32_t index, uint32_t* out, uint32_t capacity) {
  const tree* t = of;
  const node* n = &t->nodes[index];
  for (uint32_t i = 0; i < n->count && i < capacity; ++i) out[i] = t->order[n->first + i];
  return n->count;
}

static int representative(void* of, uint32_t index, uint32_t* light) {
  *light = ((tree*)of)->nodes[index].brightest;
  return 0;
}

// ---- bounds, estimates, cuts

/// Of several kinds of lights, the sum of their bounds.
static int bound(void* of, uint32_t index, const lightcuts_point* p, float out[3]) {
  const tree* t = of;
  const node* n = &t->nodes[index];
  if (n->all.kind != mixed) {
    bound_group(&n->all, t->min_distance, p, out);
    return 0;
  }
  out[0] = out[1] = out[2] = 0;
  for (uint32_t k = 0; k < n->children; ++k) {
    float part[3];
    bound(of, n->child[k], p, part);
    for (int c = 0; c < 3; ++c) out[c] = round_up((double)out[c] + part[c]);
  }
  return 0;
}

/// As if all lights were where the brightest is, and the bound at most.
static int estimate(void* of, uint32_t index, const lightcuts_point* p, const float limit[3],
                    double out[3]) {
  const tree* t = of;
  const node* n = &t->nodes[index];
  transfer(p, &t->lights[n->brightest], t->min_distance, out);
  for (int c = 0; c < 3; ++c) out[c] = fmin(out[c] * n->all.intensity[c], limit[c]);
  return 0;
}

/// Leaves are exact: 0 is left for their bound.
static void evaluate(tree* t, const lightcuts_point* p, const lightcuts_visibility* visibility,
                     lightcuts_cluster* cluster, float limit[3]) {
  const node* n = &t->nodes[cluster->node];
  for (int c = 0; c < 3; ++c) cluster->estimate[c] = limit[c] = 0;
  if (n->children > 0) {
    bound(t, cluster->node, p, limit);
    if (visibility->visible(visibility->context, n->brightest))
      estimate(t, cluster->node, p, limit, cluster->estimate);
    return;
  }
  for (uint32_t i = n->first; i < n->first + n->count; ++i) {
    const lightcuts_light* light = &t->lights[t->order[i]];
    double one[3];
    if (!visibility->visible(visibility->context, t->order[i])) continue;
    transfer(p, light, t->min_distance, one);
    for (int c = 0; c < 3; ++c) cluster->estimate[c] += one[c] * light->intensity[c];
  }
}

/// The clusters, their bounds and the total of both.
typedef struct state {
  lightcuts_cut* cut;
  float (*bounds)[3];
  double total[3], error[3];
  uint32_t largest; ///< place of the largest bound, which is refined next
} state;

/// Everything is summed anew, so that nothing drifts; a heap and a running total were faster.
static void sum(state* s) {
  float most = -1;
  for (int c = 0; c < 3; ++c) s->total[c] = s->error[c] = 0;
  for (uint32_t k = 0; k < s->cut->size; ++k) {
    const float* b = s->bounds[k];
    for (int c = 0; c < 3; ++c) {
      s->total[c] += s->cut->clusters[k].estimate[c];
      s->error[c] += b[c];
    }
    const float key = fmaxf(b[0], fmaxf(b[1], b[2]));
    if (key > most) s->largest = k;
    most = fmaxf(most, key);
  }
}

/// Whether some cluster needs refinement; where none does, the cut says why.
static int needs_more(state* s, const lightcuts_cut_config* config) {
  s->cut->end = LIGHTCUTS_END_CONVERGED;
  for (uint32_t k = 0; k < s->cut->size; ++k)
    for (int c = 0; c < 3; ++c) {
      if (s->bounds[k][c] <= config->threshold * s->total[c]) continue;
      if (s->bounds[k][c] > config->black_level) return 1;
      s->cut->end = LIGHTCUTS_END_BLACK_LEVEL;
    }
  return 0;
}

/// Refines the cluster of the largest bound until all obey. The threshold has no part in the order,
/// so that a smaller one refines the cut of a larger one.
static int select_cut(void* of, const lightcuts_point* p, const lightcuts_cut_config* config,
                      const lightcuts_visibility* visibility, lightcuts_cut* out) {
  tree* t = of;
  state s = {.cut = out, .bounds = malloc(t->size * sizeof *s.bounds)};
  if (s.bounds == NULL) return 1;
  out->size = 1;
  out->clusters[0].node = 0;
  evaluate(t, p, visibility, &out->clusters[0], s.bounds[0]);
  for (sum(&s); needs_more(&s, config); sum(&s)) {
    const node* n = &t->nodes[out->clusters[s.largest].node];
    if (out->size - 1 + n->children > config->max_size) {
      out->end = LIGHTCUTS_END_MAX_SIZE;
      break;
    }
    for (uint32_t k = 0; k < n->children; ++k) {
      const uint32_t at = k == 0 ? s.largest : out->size++;
      out->clusters[at].node = n->child[k];
      evaluate(t, p, visibility, &out->clusters[at], s.bounds[at]);
    }
  }
  for (int c = 0; c < 3; ++c) {
    out->radiance[c] = to_float(s.total[c]);
    out->certified_error[c] = certified_error(s.error[c], s.total[c]);
  }
  free(s.bounds);
  return 0;
}

// ---- sampling

/// The probabilities of a node's children or, of a leaf, of its lights, by importance, and a little
/// by number: no light is without a chance. All are 0 where none contributes.
static uint32_t odds(const tree* t, const node* n, const lightcuts_point* p,
                     double out[most_parts]) {
  const uint32_t parts = n->children > 0 ? n->children : n->count;
  double weights = 0, counts = 0, count[most_parts] = {0};
  for (uint32_t k = 0; k < parts; ++k) {
    const node* child = &t->nodes[n->child[k]];
    const group one = n->children > 0 ? child->all : group_of(&t->lights[t->order[n->first + k]]);
    out[k] = importance(&one, t->min_distance, p);
    if (out[k] > 0) count[k] = n->children > 0 ? child->count : 1;
    weights += out[k];
    counts += count[k];
  }
  for (uint32_t k = 0; k < parts && weights > 0; ++k)
    out[k] = 0.99 * (out[k] / weights) + 0.01 * (count[k] / counts);
  return parts;
}

static int probability(void* of, uint32_t index, const lightcuts_point* p, uint32_t light,
                       double* out) {
  const tree* t = of;
  double part[most_parts];
  uint32_t at = t->leaf_of[light], k = 0;
  odds(t, &t->nodes[at], p, part);
  while (t->order[t->nodes[at].first + k] != light) ++k;
  for (*out = part[k]; at != index; *out *= part[k]) {
    const uint32_t parent = t->nodes[at].parent;
    odds(t, &t->nodes[parent], p, part);
    for (k = 0; t->nodes[parent].child[k] != at;) ++k;
    at = parent;
  }
  return 0;
}

/// Goes down from the cluster; what is left of u after each turn is as random as before.
static int sample(void* of, uint32_t index, const lightcuts_point* p, double u, uint32_t* light,
                  double* out) {
  const tree* t = of;
  for (*out = 1;;) {
    const node* n = &t->nodes[index];
    double part[most_parts];
    const uint32_t parts = odds(t, n, p, part);
    uint32_t turn = parts;
    for (uint32_t k = 0; k < parts; ++k) {
      if (part[k] == 0) continue;
      if (turn < parts) u -= part[turn];
      turn = k;
      if (u < part[k]) break;
    }
    *out *= turn < parts ? part[turn] : 0;
    if (turn < parts) u = fmin(u / part[turn], 1 - 0x1p-53);
    if (*out == 0) return 0; // none contributes
    *light = t->order[n->first + turn];
    if (n->children == 0) return 0;
    index = n->child[turn];
  }
}

// ---- random cuts

/// splitmix64 (Steele, Lea and Flood 2014).
static uint64_t scrambled(uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// In [0, 1): a hash, so that those of two clusters, or of two queries, are as if independent.
static double random_number(uint64_t query, uint32_t index) {
  return (double)(scrambled(scrambled(query) ^ index) >> 11) * 0x1p-53;
}

static int all_seen(void* context, uint32_t light) {
  (void)context;
  (void)light;
  return 1;
}

/// What a light contributes if it is seen, divided by the probability with which it is drawn.
static void weigh(const tree* t, const lightcuts_point* p, uint32_t light, double probability,
                  const lightcuts_visibility* visibility, double out[3]) {
  out[0] = out[1] = out[2] = 0;
  if (probability == 0 || !visibility->visible(visibility->context, light)) return;
  transfer(p, &t->lights[light], t->min_distance, out);
  for (int c = 0; c < 3; ++c) out[c] *= t->lights[light].intensity[c] / probability;
}

/// Sums up estimates, each of which may be off by itself or by what its bound is above it.
static void sum_draws(const tree* t, const lightcuts_point* p, lightcuts_cut* out) {
  double total[3] = {0}, error[3] = {0};
  for (uint32_t k = 0; k < out->size; ++k) {
    const double* one = out->clusters[k].estimate;
    float limit[3];
    bound((void*)t, out->clusters[k].node, p, limit);
    for (int c = 0; c < 3; ++c) {
      total[c] += one[c];
      error[c] += fmax(one[c], limit[c] - one[c]);
    }
  }
  for (int c = 0; c < 3; ++c) {
    out->radiance[c] = to_float(total[c]);
    out->certified_error[c] = certified_error(error[c], total[c]);
  }
}

/// The cut is chosen as if all lights were seen, so that nothing random has a part in it.
static int draw(void* of, const lightcuts_point* p, const lightcuts_cut_config* config,
                uint64_t query, const lightcuts_visibility* visibility, lightcuts_cut* out) {
  const lightcuts_visibility all = {all_seen, NULL};
  const int failed = select_cut(of, p, config, &all, out);
  if (failed) return failed;
  for (uint32_t k = 0; k < out->size; ++k) {
    lightcuts_cluster* cluster = &out->clusters[k];
    uint32_t light = 0;
    double probability_of_it = 0;
    sample(of, cluster->node, p, random_number(query, cluster->node), &light, &probability_of_it);
    weigh(of, p, light, probability_of_it, visibility, cluster->estimate);
  }
  sum_draws(of, p, out);
  return 0;
}

// ---- what the oracle sees

const lightcuts_subject* lightcuts_subject_v1(void) {
  static const lightcuts_subject subject = {
      .abi_version = LIGHTCUTS_SUBJECT_ABI_VERSION,
      .size = sizeof(lightcuts_subject),
      .name = "top-down tree",
      .build = build,
      .destroy = destroy,
      .node_count = node_count,
      .children = children,
      .lights = lights,
      .representative = representative,
      .bound = bound,
      .estimate = estimate,
      .select = select_cut,
      .sample = sample,
      .probability = probability,
      .draw = draw,
  };
  return &subject;
}
