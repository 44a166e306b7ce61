/* SPDX-License-Identifier: MIT */
// A complete light tree for lightcuts-oracle, as short as it gets while everything holds: a tree by
// median splits, bounds from the nearest distance and the largest cosine, estimates by one light,
// cuts that refine the largest bound, lights drawn by their bounds. A start for one of your own:
//
//   cc -shared -fPIC -std=c99 -O2 -I oracle/include brute_tree.c -o libbrute_tree.so -lm
//   lightcuts-oracle check desk --subject ./libbrute_tree.so

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include <lightcuts/oracle/subject_abi.h>

static const double pi = 3.14159265358979323846;

// ---- arithmetic

/// The smallest float that is not below v >= 0: a bound may not become smaller by rounding.
static float round_up(double v) {
  if (v > FLT_MAX) return INFINITY;
  const float f = (float)v;
  return f < v ? nextafterf(f, INFINITY) : f;
}

static float round_down(double v) {
  if (v > FLT_MAX) return FLT_MAX;
  const float f = (float)v;
  return f > v ? nextafterf(f, 0) : f;
}

static float to_float(double v) { return v > FLT_MAX ? INFINITY : (float)v; }

/// n.(y - x), relative error 2^-50, zero and sign exact: whether a light is above the horizon is
/// decided by nothing else. The six products of floats are exact in double, and so is their sum as
/// six doubles that do not overlap (Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic").
static double dot_between(const float n[3], const float x[3], const float y[3]) {
  double sum[6];
  int size = 0;
  for (int i = 0; i < 6; ++i) {
    double rest = (double)n[i / 2] * (i % 2 == 0 ? y[i / 2] : -x[i / 2]);
    for (int k = 0; k < size; ++k) { // rest + sum[k] without an error
      const double total = rest + sum[k];
      const double part = total - rest;
      sum[k] = (rest - (total - part)) + (sum[k] - part);
      rest = total;
    }
    sum[size++] = rest;
  }
  double total = 0;
  for (int k = 0; k < 6; ++k) total += sum[k];
  return total;
}

static const float origin[3] = {0, 0, 0};

static double length(const float v[3]) {
  return sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
}

// ---- one light

/// n.v, with the sign exact.
static double viewer_cosine(const lightcuts_point* p) {
  return dot_between(p->normal, origin, p->to_viewer) / (length(p->normal) * length(p->to_viewer));
}

/// tan^2 of the angle between the normal and l + v: what of l + v is along the surface, over what
/// is along the normal. l = q/d.
static double half_tangent2(const lightcuts_point* p, const double q[3], double d, double up) {
  double sum[3], along = 0, square = 0;
  for (int i = 0; i < 3; ++i) {
    sum[i] = q[i] / d + p->to_viewer[i] / length(p->to_viewer);
    along += sum[i] * p->normal[i] / length(p->normal);
  }
  for (int i = 0; i < 3; ++i) {
    const double part = sum[i] - along * p->normal[i] / length(p->normal);
    square += part * part;
  }
  return square / (up * up);
}

/// (1 - v.h)^5, with 1 - cos = sin^2 / (1 + cos) where that would cancel.
static double schlick(const lightcuts_point* p, const float from[3], const float to[3], double d) {
  const float* v = p->to_viewer;
  const float x[3] = {0, -v[2], v[1]}, y[3] = {v[2], 0, -v[0]}, z[3] = {-v[1], v[0], 0};
  const double a = dot_between(x, from, to), b = dot_between(y, from, to),
               c = dot_between(z, from, to);
  const double scale = length(v) * d;
  const double cosine = fmin(fmax(dot_between(v, from, to) / scale, -1), 1);
  const double half = sqrt(0.5 * (1 + cosine)); // v.h
  const double sine2 = (a * a + b * b + c * c) / (scale * scale);
  return pow(cosine > 0 ? sine2 / (2 * (1 + cosine) * (1 + half)) : 1 - half, 5);
}

static double masked(double a2, double cosine) { return sqrt(a2 + (1 - a2) * cosine * cosine); }

/// What the glossy part reflects, f of one colour; cosine is n.l > 0.
static double lobe(const lightcuts_point* p, int colour, const float from[3], const float to[3],
                   const double q[3], double d, double cosine) {
  const lightcuts_material* m = &p->material;
  const double a2 = (double)m->width * m->width;
  if (m->lobe == LIGHTCUTS_LOBE_NONE) return 0;
  if (m->lobe == LIGHTCUTS_LOBE_PHONG) {
    const double r = dot_between(p->mirror, from, to) / (length(p->mirror) * d);
    return r <= 0 ? 0 : m->reflectance[colour] * (m->width + 2.0) / (2 * pi) * pow(r, m->width);
  }
  const double viewer = viewer_cosine(p);
  if (viewer <= 0) return 0;
  const double t = half_tangent2(p, q, d, cosine + viewer);
  if (m->lobe == LIGHTCUTS_LOBE_WARD)
    return m->reflectance[colour] * exp(-t / a2) / (4 * pi * a2 * sqrt(cosine) * sqrt(viewer));
  const double ratio = (1 + t) / (a2 + t), f0 = m->reflectance[colour];
  return (f0 + (1 - f0) * schlick(p, from, to, d)) * (a2 / pi * ratio * ratio) * 0.5 /
         (cosine * masked(a2, viewer) + viewer * masked(a2, cosine));
}

/// The share of its intensity that the light sends to the point at a distance d.
static double emission(const lightcuts_light* light, const float x[3], double d) {
  if (light->kind == LIGHTCUTS_LIGHT_OMNI || light->kind == LIGHTCUTS_LIGHT_DIRECTIONAL) return 1;
  const double cosine = dot_between(light->axis, light->position, x) / (length(light->axis) * d);
  if (light->kind == LIGHTCUTS_LIGHT_ORIENTED) return fmax(cosine, 0);
  const double rim = cosine - light->cos_outer;
  if (rim <= 0x1p-45 * fabs(light->cos_outer)) return 0; // nothing but rounding
  const double t = fmin(rim / ((double)light->cos_inner - light->cos_outer), 1);
  return t * t;
}

/// Radiance that a light of intensity 1 in the place of this one sends to the viewer.
static void transfer(const lightcuts_point* p, const lightcuts_light* light, float min_distance,
                     double out[3]) {
  const int is_far = light->kind == LIGHTCUTS_LIGHT_DIRECTIONAL;
  const float* from = is_far ? origin : p->position;
  const double n_dot_q = dot_between(p->normal, from, light->position);
  out[0] = out[1] = out[2] = 0;
  if (n_dot_q <= 0) return;
  double q[3], d2 = 0;
  for (int i = 0; i < 3; ++i) {
    q[i] = (double)light->position[i] - from[i];
    d2 += q[i] * q[i];
  }
  const double d = sqrt(d2), cosine = n_dot_q / (length(p->normal) * d);
  const double falloff = is_far ? 1 : 1 / fmax(d2, (double)min_distance * min_distance);
  const double arriving = cosine * falloff * emission(light, p->position, d);
  if (arriving == 0) return;
  for (int c = 0; c < 3; ++c)
    out[c] =
        (p->material.diffuse[c] / pi + lobe(p, c, from, light->position, q, d, cosine)) * arriving;
}

// ---- the tree

enum { mixed = 4 }; ///< in place of a kind

typedef struct node {
  uint32_t child[2];     ///< 0: a leaf
  uint32_t parent;       ///< unused of the root
  uint32_t count;        ///< of lights
  uint32_t kind;         ///< of all lights, or mixed
  uint32_t light;        ///< the brightest: it stands for them all
  float low[3], high[3]; ///< box around the lights; of directional ones, their directions
  double intensity[3];   ///< total
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
    n->low[i] = n->high[i] = t->lights[light].position[i];
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
  for (int i = 0; i < 3; ++i) {
    n->low[i] = fminf(a->low[i], b->low[i]);
    n->high[i] = fmaxf(a->high[i], b->high[i]);
    n->intensity[i] = a->intensity[i] + b->intensity[i];
  }
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

/// The most that the glossy part reflects, f n.l of one colour, n.l being at most `cosine`.
static double lobe_bound(const lightcuts_point* p, int colour, double cosine) {
  const lightcuts_material* m = &p->material;
  const double a2 = (double)m->width * m->width, reflectance = m->reflectance[colour];
  if (m->lobe == LIGHTCUTS_LOBE_NONE) return 0;
  if (m->lobe == LIGHTCUTS_LOBE_PHONG) return reflectance * (m->width + 2.0) / (2 * pi) * cosine;
  const double viewer = viewer_cosine(p);
  if (viewer <= 0) return 0;
  if (m->lobe == LIGHTCUTS_LOBE_WARD)
    return reflectance * sqrt(cosine) / (4 * pi * a2 * sqrt(viewer));
  // D is largest at T = 0, n.l V where n.l is, and F is at most 1.
  return 1 / (pi * a2) * 0.5 * cosine / (cosine * masked(a2, viewer) + viewer * masked(a2, cosine));
}

/// The corner of the box that is farthest along (or against) the normal.
static void corner(const node* n, const float normal[3], int along, float out[3]) {
  for (int i = 0; i < 3; ++i) out[i] = (normal[i] > 0) == along ? n->high[i] : n->low[i];
}

/// Squares of the distances between which the box lies.
static void distances2(const node* n, const float x[3], double* nearest, double* farthest) {
  *nearest = *farthest = 0;
  for (int i = 0; i < 3; ++i) {
    const double below = (double)n->low[i] - x[i], above = (double)x[i] - n->high[i];
    const double near_side = fmax(fmax(below, above), 0), far_side = fmax(-below, -above);
    *nearest += near_side * near_side;
    *farthest += far_side * far_side;
  }
}

/// Intensity x largest reflection x 1 / nearest distance^2; of mixed clusters the children's sum.
/// The roundings of a few multiplications in double are well within the factor 1 + 2^-40.
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
  float highest[3];
  double nearest2, farthest2;
  corner(n, p->normal, 1, highest);
  distances2(n, from, &nearest2, &farthest2);
  out[0] = out[1] = out[2] = 0;
  const double height = dot_between(p->normal, from, highest) / length(p->normal);
  if (height <= 0) return 0; // all of them are below the horizon
  const double cosine = nearest2 == 0 ? 1 : fmin(height / sqrt(nearest2), 1);
  const double falloff = is_far ? 1 : 1 / fmax(nearest2, (double)t->min_distance * t->min_distance);
  for (int c = 0; c < 3; ++c) {
    const double reflected = p->material.diffuse[c] / pi * cosine + lobe_bound(p, c, cosine);
    if (reflected > 0 && n->intensity[c] > 0) // 0 times infinity is 0 here
      out[c] = round_up(reflected * n->intensity[c] * falloff * (1 + 0x1p-40));
  }
  return 0;
}

/// The same with the smallest cosine and the farthest distance, glossy parts left out; 0 of lights
/// that may look elsewhere.
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
  float lowest[3];
  double nearest2, farthest2;
  corner(n, p->normal, 0, lowest);
  distances2(n, from, &nearest2, &farthest2);
  const double height = dot_between(p->normal, from, lowest) / length(p->normal);
  if (height <= 0) return 0;
  const double falloff =
      is_far ? 1 : 1 / fmax(farthest2, (double)t->min_distance * t->min_distance);
  for (int c = 0; c < 3; ++c)
    out[c] = round_down(p->material.diffuse[c] / pi * height / sqrt(farthest2) * falloff *
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

static int obeys(const cluster* c, const double total[3], const lightcuts_cut_config* config) {
  for (int i = 0; i < 3; ++i)
    if (c->bound[i] > config->threshold * total[i] && c->bound[i] > config->black_level) return 0;
  return 1;
}

static void sum(const cut* c, double total[3]) {
  total[0] = total[1] = total[2] = 0;
  for (uint32_t k = 0; k < c->size; ++k)
    for (int i = 0; i < 3; ++i) total[i] += c->clusters[k].estimate[i];
}

/// Whether all clusters obey beside the total summed anew; the first one is asked before the
/// others.
static int all_obey(const cut* c, const lightcuts_cut_config* config) {
  if (!obeys(&c->clusters[0], c->total, config)) return 0;
  double total[3];
  sum(c, total);
  for (uint32_t k = 0; k < c->size; ++k)
    if (!obeys(&c->clusters[k], total, config)) return 0;
  return 1;
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

/// Why refinement ended where all clusters obey: whether one of them needed the black level.
static uint32_t end_of(const cut* c, const lightcuts_cut_config* config) {
  double total[3];
  sum(c, total);
  for (uint32_t k = 0; k < c->size; ++k)
    for (int i = 0; i < 3; ++i)
      if (c->clusters[k].bound[i] > config->threshold * total[i]) return LIGHTCUTS_END_BLACK_LEVEL;
  return LIGHTCUTS_END_CONVERGED;
}

/// Writes what was found. The error is at most the sum of the bounds, and the rounding of all
/// estimates and sums, for which 2^-23 is plenty.
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
    const double certified = (error[i] + total[i] * 0x1p-23 + 0x1p-149) * (1 + 0x1p-30);
    out->radiance[i] = to_float(total[i]);
    out->certified_error[i] = total[i] > FLT_MAX ? INFINITY : round_up(certified);
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
  int full = 0;
  while (key(&c.clusters[0]) > 0 && !all_obey(&c, config)) {
    full = c.size >= config->max_size;
    if (full) break;
    refine(t, &c, p, visibility);
  }
  finish(&c, full ? LIGHTCUTS_END_MAX_SIZE : end_of(&c, config), out);
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
