/* SPDX-License-Identifier: MIT */
// The least that can be judged: a light tree that has bounds and nothing else. Node i has the
// children 2i+1 and 2i+2, as in a heap, and the leaves are the lights in the order given. Wants
// shading.h beside it:
//
//   cc -shared -fPIC -std=c99 -O2 -I oracle/include bounds_only.c -o libbounds_only.so -lm
//   lightcuts-oracle stress --subject ./libbounds_only.so

#include <stdlib.h>

#include "shading.h"

/// Lights near and far: those of the one kind are bounded by their box, directional ones by their
/// irradiance.
typedef struct node {
  box near;
  double near_intensity[3], far_intensity[3]; ///< totals
} node;

typedef struct tree {
  uint32_t count; ///< of lights
  float min_distance;
  node nodes[];
} tree;

static node leaf(const lightcuts_light* light) {
  const int is_far = light->kind == LIGHTCUTS_LIGHT_DIRECTIONAL;
  node n = {{{0}, {0}}, {0}, {0}};
  for (int i = 0; i < 3; ++i) {
    n.near.low[i] = is_far ? INFINITY : light->position[i];
    n.near.high[i] = is_far ? -INFINITY : light->position[i];
    (is_far ? n.far_intensity : n.near_intensity)[i] = light->intensity[i];
  }
  return n;
}

static node joined(const node* a, const node* b) {
  node n = *a;
  cover(&n.near, &b->near);
  for (int i = 0; i < 3; ++i) {
    n.near_intensity[i] += b->near_intensity[i];
    n.far_intensity[i] += b->far_intensity[i];
  }
  return n;
}

static void* build(const lightcuts_light* lights, uint32_t count, float min_distance,
                   uint64_t seed) {
  (void)seed;
  tree* t = malloc(sizeof *t + (2 * (size_t)count - 1) * sizeof *t->nodes);
  if (t == NULL) return NULL;
  t->count = count;
  t->min_distance = min_distance;
  for (size_t i = 2 * (size_t)count - 1; i-- > 0;)
    t->nodes[i] = i + 1 >= count ? leaf(&lights[i + 1 - count])
                                 : joined(&t->nodes[2 * i + 1], &t->nodes[2 * i + 2]);
  return t;
}

static uint32_t node_count(void* of) { return 2 * ((tree*)of)->count - 1; }

static uint32_t children(void* of, uint32_t index, uint32_t* out, uint32_t capacity) {
  if (index + 1 >= ((tree*)of)->count) return 0;
  for (uint32_t k = 0; k < 2 && k < capacity; ++k) out[k] = 2 * index + 1 + k;
  return 2;
}

static uint32_t lights(void* of, uint32_t index, uint32_t* out, uint32_t capacity) {
  if (capacity > 0) out[0] = index + 1 - ((tree*)of)->count;
  return 1;
}

/// Total intensity x largest reflection x 1 / nearest distance^2, and of what comes from afar,
/// irradiance x largest reflection.
static int bound(void* of, uint32_t index, const lightcuts_point* p, float out[3]) {
  const tree* t = of;
  const node* n = &t->nodes[index];
  const int is_near = n->near.low[0] <= n->near.high[0];
  const int shines = is_near && height(&n->near, p->normal, p->position, 1) > 0;
  const double d2 = is_near ? nearest2(&n->near, p->position) : 0;
  const double falloff = 1 / fmax(d2, (double)t->min_distance * t->min_distance);
  for (int c = 0; c < 3; ++c) {
    const double near_part =
        shines ? reflected_bound(p, c, 1, 1, n->near_intensity[c], falloff) : 0;
    const double far_part = reflected_bound(p, c, 1, 1, n->far_intensity[c], 1);
    out[c] = round_up(near_part + far_part);
  }
  return 0;
}

const lightcuts_subject* lightcuts_subject_v1(void) {
  static const lightcuts_subject subject = {
      .abi_version = LIGHTCUTS_SUBJECT_ABI_VERSION,
      .size = sizeof(lightcuts_subject),
      .name = "bounds only",
      .build = build,
      .destroy = free,
      .node_count = node_count,
      .children = children,
      .lights = lights,
      .bound = bound,
  };
  return &subject;
}
