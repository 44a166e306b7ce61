/* SPDX-License-Identifier: MIT */
// The top-down example, but for what FAULT names of how it lights a cut.
#define lightcuts_subject_v1 right_subject
#include "top_down_tree.c"
#undef lightcuts_subject_v1

#include <stddef.h>

static int fault_is(const char* name) { return strcmp(FAULT, name) == 0; }

/// One of the cluster's lights, each as likely as the others.
static uint32_t any_light(const tree* t, uint32_t index, double u) {
  const node* n = &t->nodes[index];
  return t->order[n->first + (uint32_t)(u * n->count)];
}

static int faulty_draw(void* of, const lightcuts_point* p, const lightcuts_cut_config* config,
                       uint64_t query, const lightcuts_visibility* visibility, lightcuts_cut* out) {
  const int failed = draw(of, p, config, query, visibility, out);
  if (failed) return failed;
  for (uint32_t k = 0; k < out->size; ++k) {
    lightcuts_cluster* cluster = &out->clusters[k];
    const double u = random_number(query, fault_is("one_number_for_all") ? 0 : cluster->node);
    uint32_t light = 0;
    double chance = 0;
    sample(of, cluster->node, p, u, &light, &chance);
    if (fault_is("drawn_evenly") && chance > 0) light = any_light(of, cluster->node, u);
    if (fault_is("drawn_evenly")) probability(of, cluster->node, p, light, &chance);
    weigh(of, p, light, chance, visibility, cluster->estimate);
  }
  sum_draws(of, p, out);
  if (fault_is("cut_by_query") && query % 2 == 0 && out->size > 1) {
    const lightcuts_cluster first = out->clusters[0];
    out->clusters[0] = out->clusters[1];
    out->clusters[1] = first;
  }
  if (fault_is("draws_no_node")) out->clusters[0].node = 123456789;
  return 0;
}

const lightcuts_subject* lightcuts_subject_v1(void) {
  static lightcuts_subject subject;
  subject = *right_subject();
  subject.name = FAULT;
  subject.draw = faulty_draw;
  // As of the header before there were random cuts: what lies behind is not to be read.
  if (fault_is("older_table")) subject.size = offsetof(lightcuts_subject, draw);
  return &subject;
}
