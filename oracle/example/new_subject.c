/* SPDX-License-Identifier: MIT */
// A light tree for lightcuts-oracle in one file, right and as plain as can be, to be replaced part
// by part. It has bounds, and draws lights by their power:
//
//   cc -shared -fPIC -std=c99 -O2 -I oracle/include new_subject.c -o libnew_subject.so -lm
//   lightcuts-oracle stress --subject ./libnew_subject.so

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <lightcuts/oracle/subject_abi.h>

// ---- the tree

/* REPLACE: what you know of a cluster */
typedef struct node {
  uint32_t first, count; ///< of its lights, in the order given
  uint32_t child[2];     ///< unused of a leaf, which has one light
  float low[3], high[3]; ///< a box around its lights, but for directional ones
  double near[3];        ///< total intensity of the lights in the box
  double far[3];         ///< total of the directional ones
} node;

typedef struct tree {
  lightcuts_light* lights;
  node* nodes;
  uint32_t size; ///< of nodes
  float min_distance;
} tree;

static void measure(const tree* t, node* n) {
  for (int i = 0; i < 3; ++i) {
    n->low[i] = INFINITY;
    n->high[i] = -INFINITY;
  }
  for (uint32_t k = n->first; k < n->first + n->count; ++k) {
    const lightcuts_light* light = &t->lights[k];
    const int is_far = light->kind == LIGHTCUTS_LIGHT_DIRECTIONAL;
    for (int i = 0; i < 3; ++i) {
      (is_far ? n->far : n->near)[i] += light->intensity[i];
      if (is_far) continue;
      n->low[i] = fminf(n->low[i], light->position[i]);
      n->high[i] = fmaxf(n->high[i], light->position[i]);
    }
  }
}

/* REPLACE: how lights are clustered; here each half of the list is a child */
static uint32_t make_node(tree* t, uint32_t first, uint32_t count) {
  const uint32_t index = t->size++;
  node* n = &t->nodes[index];
  n->first = first;
  n->count = count;
  measure(t, n);
  if (count == 1) return index;
  n->child[0] = make_node(t, first, count / 2);
  n->child[1] = make_node(t, first + count / 2, count - count / 2);
  return index;
}

static void destroy(void* of) {
  tree* t = of;
  if (t == NULL) return;
  free(t->lights);
  free(t->nodes);
  free(t);
}

static void* build(const lightcuts_light* lights, uint32_t count, float min_distance,
                   uint64_t seed) {
  (void)seed; // nothing is random here
  tree* t = calloc(1, sizeof *t);
  if (t == NULL) return NULL;
  t->min_distance = min_distance;
  t->lights = calloc(count, sizeof *t->lights);
  t->nodes = calloc(2 * (size_t)count - 1, sizeof *t->nodes);
  if (t->lights == NULL || t->nodes == NULL) {
    destroy(t);
    return NULL;
  }
  memcpy(t->lights, lights, count * sizeof *lights);
  make_node(t, 0, count);
  return t;
}

static uint32_t node_count(void* of) { return ((tree*)of)->size; }

static uint32_t children(void* of, uint32_t index, uint32_t* out, uint32_t capacity) {
  const node* n = &((tree*)of)->nodes[index];
  if (n->count == 1) return 0;
  for (uint32_t k = 0; k < 2 && k < capacity; ++k) out[k] = n->child[k];
  return 2;
}

static uint32_t lights(void* of, uint32_t index, uint32_t* out, uint32_t capacity) {
  if (capacity > 0) out[0] = ((tree*)of)->nodes[index].first;
  return 1;
}

// ---- bounds

static const double pi = 3.14159265358979323846;

/// The smallest float that is not below v >= 0: a bound may not become smaller by rounding.
static float round_up(double v) {
  if (v > FLT_MAX) return INFINITY;
  const float f = (float)v;
  return f < v ? nextafterf(f, INFINITY) : f;
}

/// At most n.v, and above 0 only if that is, too: 2^-50 of its terms is more than they round.
static double least_viewer_cosine(const lightcuts_point* p) {
  double sum = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    const double term = (double)p->normal[i] * p->to_viewer[i];
    sum += term;
    size += fabs(term);
  }
  return 0.999 * (sum - 0x1p-50 * size); // directions are unit within 1e-5
}

/* REPLACE: the most that a material reflects of any light, f n.l; here whatever n.l is */
static double largest_reflection(const lightcuts_point* p, int colour) {
  const lightcuts_material* m = &p->material;
  const double a = m->width, lambertian = m->diffuse[colour] / pi;
  double lobe = 0;
  if (m->lobe == LIGHTCUTS_LOBE_PHONG) lobe = m->reflectance[colour] * (a + 2) / (2 * pi);
  if (m->lobe == LIGHTCUTS_LOBE_COOK_TORRANCE) lobe = 1 / (2 * pi * a * a * a);
  if (m->lobe == LIGHTCUTS_LOBE_WARD && m->reflectance[colour] > 0) {
    const double cosine = least_viewer_cosine(p);
    lobe = cosine > 0 ? m->reflectance[colour] / (4 * pi * a * a * sqrt(cosine)) : INFINITY;
  }
  return lambertian + lobe;
}

static double nearest_distance2(const node* n, const float x[3]) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double below = (double)n->low[i] - x[i], above = (double)x[i] - n->high[i];
    const double d = fmax(fmax(below, above), 0);
    sum += d * d;
  }
  return sum;
}

/* REPLACE: your bound; here intensity x largest reflection / nearest distance^2, as if all lights
   shone at the point with all their might */
static int bound(void* of, uint32_t index, const lightcuts_point* p, float out[3]) {
  const tree* t = of;
  const node* n = &t->nodes[index];
  const double d2 =
      fmax(nearest_distance2(n, p->position), (double)t->min_distance * t->min_distance);
  for (int c = 0; c < 3; ++c) {
    // 0 / 0 were NaN.
    const double arriving = (n->near[c] > 0 ? n->near[c] / d2 : 0) + n->far[c];
    const double reflected = largest_reflection(p, c);
    // The factor is more than all of this rounds.
    out[c] = arriving > 0 && reflected > 0 ? round_up(arriving * reflected * (1 + 0x1p-40)) : 0;
  }
  return 0;
}

// ---- sampling

static double power(const lightcuts_light* light) {
  return (double)light->intensity[0] + light->intensity[1] + light->intensity[2];
}

static double total_power(const tree* t, const node* n) {
  double sum = 0;
  for (uint32_t k = n->first; k < n->first + n->count; ++k) sum += power(&t->lights[k]);
  return sum;
}

/* REPLACE: how likely a light is drawn; it may depend on the point */
static int probability(void* of, uint32_t index, const lightcuts_point* p, uint32_t light,
                       double* out) {
  const tree* t = of;
  const double total = total_power(t, &t->nodes[index]);
  (void)p;
  *out = total > 0 ? power(&t->lights[light]) / total : 0;
  return 0;
}

/* REPLACE: how a light is drawn, as often as probability() says */
static int sample(void* of, uint32_t index, const lightcuts_point* p, double u, uint32_t* light,
                  double* out) {
  const tree* t = of;
  const node* n = &t->nodes[index];
  double left = u * total_power(t, n);
  *light = n->first;
  for (uint32_t k = n->first; k < n->first + n->count; ++k) {
    const double one = power(&t->lights[k]);
    if (one == 0) continue;
    *light = k;
    if (left < one) break;
    left -= one;
  }
  return probability(of, index, p, *light, out);
}

// ---- what the oracle sees

const lightcuts_subject* lightcuts_subject_v1(void) {
  static const lightcuts_subject subject = {
      .abi_version = LIGHTCUTS_SUBJECT_ABI_VERSION,
      .size = sizeof(lightcuts_subject),
      .name = "new_subject",
      .build = build,
      .destroy = destroy,
      .node_count = node_count,
      .children = children,
      .lights = lights,
      .bound = bound,
      .sample = sample,
      .probability = probability,
      /* REPLACE: add what else you have: representative, intensity, lower_bound, estimate, select,
         refined_before, draw; lightcuts/oracle/subject_abi.h says what each promises */
  };
  return &subject;
}
