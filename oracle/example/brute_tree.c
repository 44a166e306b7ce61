/* SPDX-License-Identifier: MIT */
// A complete light tree for lightcuts-oracle, as short as it gets while everything holds: a tree by
// median splits, bounds from the nearest distance and the largest cosine, estimates by one light,
// cuts that refine the largest bound, lights drawn by their bounds. A start for one of your own,
// with shading.h beside it:
//
//   cc -shared -fPIC -std=c99 -O2 -I oracle/include brute_tree.c -o libbrute_tree.so -lm
//   lightcuts-oracle check desk --subject ./libbrute_tree.so

#include <stdlib.h>

#include "shading.h"

// ---- the tree

enum { mixed = 4 }; ///< in place of a kind

typedef struct node {
  uint32_t child[2];   ///< 0: a leaf
  uint32_t parent;     ///< unused of the root
  uint32_t count;      ///< of lights
  uint32_t kind;       ///< of all lights, or mixed
  uint32_t light;      ///< the brightest: it stands for them all
  box box;             ///< around the lights; of directional ones, their directions
  double intensity[3]; ///< total
} node;

typedef struct tree {
  lightcuts_light* lights;
  node* nodes;
  uint32_t* leaf_of; ///< of each light
  uint32_t size;
  float min_distance;
} tree;

/// A light to be sorted.
typedef struct entry {
  float key;
  uint32_t light;
} entry;

static int by_key(const void* a, const void* b) {
  const entry *x = a, *y = b;
  if (x->key != y->key) return x->key < y->key ? -1 : 1;
  return x->light < y->light ? -1 : x->light > y->light;
}

static double brightness(const lightcuts_light* light) {
  return (double)light->intensity[0] + light->intensity[1] + light->intensity[2];
}

static void make_leaf(tree* t, uint32_t index, uint32_t light) {
  node* n = &t->nodes[index];
  n->count = 1;
  n->light = light;
  n->kind = t->lights[light].kind;
  for (int i = 0; i < 3; ++i) {
    n->box.low[i] = n->box.high[i] = t->lights[light].position[i];
    n->intensity[i] = t->lights[light].intensity[i];
  }
  t->leaf_of[light] = index;
}

static void join(tree* t, uint32_t index) {
  node* n = &t->nodes[index];
  const node *a = &t->nodes[n->child[0]], *b = &t->nodes[n->child[1]];
  n->count = a->count + b->count;
  n->kind = a->kind == b->kind ? a->kind : (uint32_t)mixed;
  n->light =
      brightness(&t->lights[a->light]) >= brightness(&t->lights[b->light]) ? a->light : b->light;
  n->box = a->box;
  cover(&n->box, &b->box);
  for (int i = 0; i < 3; ++i) n->intensity[i] = a->intensity[i] + b->intensity[i];
}

/// Where to split: kinds apart, else in the middle of the longest side. The entries are sorted.
static uint32_t split(const tree* t, entry* entries, uint32_t count) {
  const uint32_t kind = t->lights[entries[0].light].kind;
  float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
  for (uint32_t i = 0; i < count; ++i) {
    const lightcuts_light* light = &t->lights[entries[i].light];
    if (light->kind != kind) return i; // build() has sorted them by kind
    for (int k = 0; k < 3; ++k) {
      low[k] = fminf(low[k], light->position[k]);
      high[k] = fmaxf(high[k], light->position[k]);
    }
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if ((double)high[k] - low[k] > (double)high[axis] - low[axis]) axis = k;
  for (uint32_t i = 0; i < count; ++i) entries[i].key = t->lights[entries[i].light].position[axis];
  qsort(entries, count, sizeof *entries, by_key);
  return count / 2;
}

static uint32_t make_node(tree* t, entry* entries, uint32_t count) {
  const uint32_t index = t->size++;
  t->nodes[index].child[0] = t->nodes[index].child[1] = 0;
  if (count == 1) {
    make_leaf(t, index, entries[0].light);
    return index;
  }
  const uint32_t half = split(t, entries, count);
  for (int k = 0; k < 2; ++k) {
    const uint32_t child =
        make_node(t, k == 0 ? entries : entries + half, k == 0 ? half : count - half);
    t->nodes[index].child[k] = child;
    t->nodes[child].parent = index;
  }
  join(t, index);
  return index;
}

static void destroy(void* of) {
  tree* t = of;
  if (t == NULL) return;
  free(t->lights);
  free(t->nodes);
  free(t->leaf_of);
  free(t);
}

static void* build(const lightcuts_light* lights, uint32_t count, float min_distance,
                   uint64_t seed) {
  (void)seed; // nothing is random here
  tree* t = calloc(1, sizeof *t);
  entry* entries = calloc(count, sizeof *entries);
  if (t != NULL) {
    t->lights = calloc(count, sizeof *t->lights);
    t->nodes = calloc(2 * (size_t)count, sizeof *t->nodes);
    t->leaf_of = calloc(count, sizeof *t->leaf_of);
    t->min_distance = min_distance;
  }
  if (t == NULL || entries == NULL || t->lights == NULL || t->nodes == NULL || t->leaf_of == NULL) {
    destroy(t);
    free(entries);
    return NULL;
  }
  for (uint32_t i = 0; i < count; ++i) {
    t->lights[i] = lights[i];
    entries[i].key = (float)lights[i].kind;
    entries[i].light = i;
  }
  qsort(entries, count, sizeof *entries, by_key);
  make_node(t, entries, count);
  free(entries);
  return t;
}

static uint32_t node_count(void* of) { return ((tree*)of)->size; }

static uint32_t children(void* of, uint32_t index, uint32_t* out, uint32_t capacity) {
  const node* n = &((tree*)of)->nodes[index];
  if (n->child[0] == 0) return 0;
  for (uint32_t k = 0; k < 2 && k < capacity; ++k) out[k] = n->child[k];
  return 2;
}

static uint32_t lights(void* of, uint32_t index, uint32_t* out, uint32_t capacity) {
  if (capacity > 0) out[0] = ((tree*)of)->nodes[index].light;
  return 1;
}

static int representative(void* of, uint32_t index, uint32_t* light) {
  *light = ((tree*)of)->nodes[index].light;
  return 0;
}

static int intensity(void* of, uint32_t index, double out[3]) {
  for (int c = 0; c < 3; ++c) out[c] = ((tree*)of)->nodes[index].intensity[c];
  return 0;
}

// ---- bounds

static float round_down(double v) {
  if (v > FLT_MAX) return FLT_MAX;
  const float f = (float)v;
  return f > v ? nextafterf(f, 0) : f;
}

/// Intensity x largest reflection x 1 / nearest distance^2; of mixed clusters the children's sum.
static int bound(void* of, uint32_t index, const lightcuts_point* p, float out[3]) {
  const tree* t = of;
  const node* n = &t->nodes[index];
  if (n->kind == mixed) {
    float a[3], b[3];
    bound(of, n->child[0], p, a);
    bound(of, n->child[1], p, b);
    for (int c = 0; c < 3; ++c) out[c] = round_up((double)a[c] + b[c]);
    return 0;
  }
  const int is_far = n->kind == LIGHTCUTS_LIGHT_DIRECTIONAL;
  const float* from = is_far ? origin : p->position;
  out[0] = out[1] = out[2] = 0;
  const double highest = height(&n->box, p->normal, from, 1);
  if (highest <= 0) return 0; // all of them are below the horizon
  const double d2 = nearest2(&n->box, from);
  const double cosine = d2 == 0 ? 1 : fmin(highest / sqrt(d2), 1);
  const double falloff = is_far ? 1 : 1 / fmax(d2, (double)t->min_distance * t->min_distance);
  for (int c = 0; c < 3; ++c) out[c] = reflected_bound(p, c, cosine, 1, n->intensity[c], falloff);
  return 0;
}

static double farthest2(const box* b, const float x[3]) {
  double d2 = 0;
  for (int i = 0; i < 3; ++i) {
    const double d = fmax((double)x[i] - b->low[i], (double)b->high[i] - x[i]);
    d2 += d * d;
  }
  return d2;
}

/// Intensity x smallest diffuse reflection x 1 / farthest distance^2; 0 of lights that may look
/// elsewhere. Glossy parts are left out.
static int lower_bound(void* of, uint32_t index, const lightcuts_point* p, float out[3]) {
  const tree* t = of;
  const node* n = &t->nodes[index];
  out[0] = out[1] = out[2] = 0;
  if (n->kind == mixed) {
    float a[3], b[3];
    lower_bound(of, n->child[0], p, a);
    lower_bound(of, n->child[1], p, b);
    for (int c = 0; c < 3; ++c) out[c] = round_down((double)a[c] + b[c]);
    return 0;
  }
  if (n->kind == LIGHTCUTS_LIGHT_ORIENTED || n->kind == LIGHTCUTS_LIGHT_SPOT) return 0;
  const int is_far = n->kind == LIGHTCUTS_LIGHT_DIRECTIONAL;
  const float* from = is_far ? origin : p->position;
  const double lowest = height(&n->box, p->normal, from, 0);
  if (lowest <= 0) return 0;
  const double d2 = farthest2(&n->box, from);
  const double falloff = is_far ? 1 : 1 / fmax(d2, (double)t->min_distance * t->min_distance);
  for (int c = 0; c < 3; ++c)
    out[c] = round_down(p->material.diffuse[c] / pi * lowest / sqrt(d2) * falloff *
                        n->intensity[c] * (1 - 0x1p-40));
  return 0;
}

// ---- estimates and cuts

/// As if all lights were where the brightest is; of one light that is exact. Between 0 and the
/// bound, and so no more wrong than the bound says.
static int estimate(void* of, uint32_t index, const lightcuts_point* p, const float limit[3],
                    double out[3]) {
  const tree* t = of;
  const node* n = &t->nodes[index];
  transfer(p, &t->lights[n->light], t->min_distance, out);
  for (int c = 0; c < 3; ++c) {
    out[c] *= n->intensity[c];
    if (n->count > 1) out[c] = fmin(out[c], limit[c]);
  }
  return 0;
}

/// A cluster of a cut in the making.
typedef struct cluster {
  float bound[3]; ///< 0 of one light
  uint32_t index;
  double estimate[3];
} cluster;

typedef struct cut {
  cluster* clusters; ///< a heap: the first has the largest bound
  uint32_t size;
  double total[3];
} cut;

static float key(const cluster* c) { return fmaxf(c->bound[0], fmaxf(c->bound[1], c->bound[2])); }

/// By bound, and between equal ones by index: the threshold has no part in the order, so that a
/// smaller one refines the cut of a larger one.
static int before(const cluster* a, const cluster* b) {
  return key(a) != key(b) ? key(a) > key(b) : a->index < b->index;
}

static void swap(cluster* a, cluster* b) {
  const cluster c = *a;
  *a = *b;
  *b = c;
}

static void sink(cut* c, uint32_t i) {
  for (;;) {
    uint32_t first = i;
    for (uint32_t k = 2 * i + 1; k <= 2 * i + 2 && k < c->size; ++k)
      if (before(&c->clusters[k], &c->clusters[first])) first = k;
    if (first == i) return;
    swap(&c->clusters[i], &c->clusters[first]);
    i = first;
  }
}

static void push(cut* c, const cluster* one) {
  uint32_t i = c->size++;
  c->clusters[i] = *one;
  for (; i > 0 && before(&c->clusters[i], &c->clusters[(i - 1) / 2]); i = (i - 1) / 2)
    swap(&c->clusters[i], &c->clusters[(i - 1) / 2]);
}

static void pop(cut* c) {
  c->clusters[0] = c->clusters[--c->size];
  sink(c, 0);
}

static cluster evaluated(tree* t, uint32_t index, const lightcuts_point* p,
                         const lightcuts_visibility* visibility) {
  const node* n = &t->nodes[index];
  cluster c = {{0, 0, 0}, index, {0, 0, 0}};
  if (n->count > 1) bound(t, index, p, c.bound);
  if (visibility->visible(visibility->context, n->light))
    estimate(t, index, p, c.bound, c.estimate);
  return c;
}

static int obeys(const cluster* c, const double total[3], float threshold, float black_level) {
  for (int i = 0; i < 3; ++i)
    if (c->bound[i] > threshold * total[i] && c->bound[i] > black_level) return 0;
  return 1;
}

static void sum(const cut* c, double total[3]) {
  total[0] = total[1] = total[2] = 0;
  for (uint32_t k = 0; k < c->size; ++k)
    for (int i = 0; i < 3; ++i) total[i] += c->clusters[k].estimate[i];
}

/// Whether all clusters obey beside the total summed anew.
static int all_obey(const cut* c, float threshold, float black_level) {
  double total[3];
  sum(c, total);
  for (uint32_t k = 0; k < c->size; ++k)
    if (!obeys(&c->clusters[k], total, threshold, black_level)) return 0;
  return 1;
}

/// The first cluster is asked before the others, beside a total that may have drifted.
static int needs_more(const cut* c, const lightcuts_cut_config* config) {
  const cluster* first = &c->clusters[0];
  if (key(first) == 0) return 0; // lights alone
  return !obeys(first, c->total, config->threshold, config->black_level) ||
         !all_obey(c, config->threshold, config->black_level);
}

static uint32_t reason(const cut* c, const lightcuts_cut_config* config) {
  if (all_obey(c, config->threshold, 0)) return LIGHTCUTS_END_CONVERGED;
  return all_obey(c, config->threshold, config->black_level) ? LIGHTCUTS_END_BLACK_LEVEL
                                                             : LIGHTCUTS_END_MAX_SIZE;
}

static void refine(tree* t, cut* c, const lightcuts_point* p,
                   const lightcuts_visibility* visibility) {
  const cluster parent = c->clusters[0];
  pop(c);
  for (int i = 0; i < 3; ++i) c->total[i] -= parent.estimate[i];
  for (int k = 0; k < 2; ++k) {
    const cluster child = evaluated(t, t->nodes[parent.index].child[k], p, visibility);
    for (int i = 0; i < 3; ++i) c->total[i] += child.estimate[i];
    push(c, &child);
  }
}

/// Writes what was found.
static void finish(const cut* c, uint32_t end, lightcuts_cut* out) {
  double total[3], error[3] = {0, 0, 0};
  sum(c, total);
  for (uint32_t k = 0; k < c->size; ++k) {
    out->clusters[k].node = c->clusters[k].index;
    for (int i = 0; i < 3; ++i) {
      out->clusters[k].estimate[i] = c->clusters[k].estimate[i];
      error[i] += c->clusters[k].bound[i];
    }
  }
  for (int i = 0; i < 3; ++i) {
    out->radiance[i] = to_float(total[i]);
    out->certified_error[i] = certified_error(error[i], total[i]);
  }
  out->size = c->size;
  out->end = end;
}

/// Refines the cluster of the largest bound until all obey.
static int select_cut(void* of, const lightcuts_point* p, const lightcuts_cut_config* config,
                      const lightcuts_visibility* visibility, lightcuts_cut* out) {
  tree* t = of;
  cut c = {malloc(t->size * sizeof(cluster)), 0, {0, 0, 0}};
  if (c.clusters == NULL) return 1;
  const cluster root = evaluated(t, 0, p, visibility);
  push(&c, &root);
  sum(&c, c.total);
  while (c.size < config->max_size && needs_more(&c, config)) refine(t, &c, p, visibility);
  finish(&c, reason(&c, config), out);
  free(c.clusters);
  return 0;
}

static int refined_before(double one, double other) { return one > other; }

// ---- sampling

/// The probability of going to the first child: half by bounds, half by the numbers of lights, so
/// that no light is without a chance.
static double first_child_probability(tree* t, const node* n, const lightcuts_point* p) {
  double weight[2];
  for (int k = 0; k < 2; ++k) {
    float b[3];
    bound(t, n->child[k], p, b);
    weight[k] = (double)b[0] + b[1] + b[2];
  }
  const double by_count = (double)t->nodes[n->child[0]].count / n->count;
  const double total = weight[0] + weight[1];
  if (!(total > 0) || total > DBL_MAX) return by_count;
  return 0.5 * (weight[0] / total) + 0.5 * by_count;
}

static double probability_below(tree* t, uint32_t top, const lightcuts_point* p, uint32_t index) {
  if (index == top) return 1;
  const uint32_t parent = t->nodes[index].parent;
  const double first = first_child_probability(t, &t->nodes[parent], p);
  const int is_first = t->nodes[parent].child[0] == index;
  return probability_below(t, top, p, parent) * (is_first ? first : 1 - first);
}

static int probability(void* of, uint32_t index, const lightcuts_point* p, uint32_t light,
                       double* out) {
  tree* t = of;
  *out = probability_below(t, index, p, t->leaf_of[light]);
  return 0;
}

/// Goes down from the cluster; what is left of u after each turn is as random as before.
static int sample(void* of, uint32_t index, const lightcuts_point* p, double u, uint32_t* light,
                  double* out) {
  tree* t = of;
  uint32_t at = index;
  while (t->nodes[at].count > 1) {
    const double first = first_child_probability(t, &t->nodes[at], p);
    const int turn = u >= first;
    u = fmin(turn ? (u - first) / (1 - first) : u / first, 1 - 0x1p-53);
    at = t->nodes[at].child[turn];
  }
  *light = t->nodes[at].light;
  *out = probability_below(t, index, p, at);
  return 0;
}

// ---- what the oracle sees

const lightcuts_subject* lightcuts_subject_v1(void) {
  static const lightcuts_subject subject = {
      .abi_version = LIGHTCUTS_SUBJECT_ABI_VERSION,
      .size = sizeof(lightcuts_subject),
      .name = "brute tree",
      .build = build,
      .destroy = destroy,
      .node_count = node_count,
      .children = children,
      .lights = lights,
      .representative = representative,
      .intensity = intensity,
      .bound = bound,
      .lower_bound = lower_bound,
      .estimate = estimate,
      .select = select_cut,
      .sample = sample,
      .probability = probability,
      .refined_before = refined_before,
  };
  return &subject;
}
