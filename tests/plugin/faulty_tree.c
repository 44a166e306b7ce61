/* SPDX-License-Identifier: MIT */
// A root with a leaf for each light, bounds of plus infinity, lights drawn evenly: right as it is,
// and wrong in the one way that FAULT names. Cuts are offered only where they are what is wrong.
#define _POSIX_C_SOURCE 200809L // fork(), pause()
#include <lightcuts/oracle/subject_abi.h>

#include <fenv.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int fault_is(const char* name) { return strcmp(FAULT, name) == 0; }

static int fault_begins(const char* name) { return strncmp(FAULT, name, strlen(name)) == 0; }

static void hang(void) {
  for (;;) pause();
}

/// Crashes, hangs or exits if that is wanted in this function.
static void misbehave_in(const char* function) {
  const char* in = strstr(FAULT, "_in_");
  if (in == NULL || strcmp(in + 4, function) != 0) return;
  if (fault_begins("crash")) raise(SIGSEGV);
  if (fault_begins("hang")) hang();
  if (fault_begins("exit")) exit(3);
}

__attribute__((constructor)) static void when_loaded(void) { misbehave_in("load"); }

static unsigned builds = 0;

/// The lights are leaves 1, 2, ... of the root.
typedef struct tree {
  uint32_t count;
} tree;

/// Rounds upwards, and takes subnormals for 0.
static void spoil_arithmetic(void) {
  fesetround(FE_UPWARD);
#ifdef __SSE__
  __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040);
#endif
}

static int arithmetic_is_usual(void) {
  volatile float subnormal = 0x1p-140F;
  return fegetround() == FE_TONEAREST && subnormal * 0.5F > 0;
}

static void harm_the_process(void) {
  if (fault_is("prints_much"))
    for (int i = 0; i < 20000; ++i) puts("0123456789012345678901234567890123456789012345");
  if (fault_is("spoils_arithmetic")) spoil_arithmetic();
  if (fault_is("forks_a_sleeper") && fork() == 0) hang();
  if (fault_is("hoards_and_aborts") || fault_is("hoards"))
    while (malloc(1 << 20) != NULL) continue;
  if (fault_is("hoards_and_aborts")) abort();
  if (fault_is("prints")) {
    puts("this is not JSON");
    fflush(stdout);
  }
  if (fault_is("closes_connection")) {
    close(3);
    hang();
  }
  if (fault_is("writes_to_connection")) {
    char junk[64];
    memset(junk, 'x', sizeof junk);
    if (write(3, junk, sizeof junk) < 0) exit(1);
  }
  if (fault_is("forks_and_hangs")) {
    if (fork() == 0) hang();
    abort();
  }
}

static void* build(const lightcuts_light* lights, uint32_t count, float min_distance,
                   uint64_t seed) {
  (void)lights;
  (void)min_distance;
  (void)seed;
  misbehave_in("build");
  ++builds;
  harm_the_process();
  if (fault_is("null_tree") || fault_is("hoards")) return NULL;
  tree* t = malloc(sizeof *t);
  if (t != NULL) t->count = count;
  return t;
}

static void destroy(void* t) {
  misbehave_in("destroy");
  free(t);
}

static uint32_t node_count(void* of) {
  if (fault_is("many_nodes")) return UINT32_MAX;
  if (fault_is("no_nodes")) return 0;
  return ((tree*)of)->count + 1;
}

static uint32_t children(void* of, uint32_t node, uint32_t* out, uint32_t capacity) {
  const tree* t = of;
  if (node == 1 && (fault_is("child_cycle") || fault_is("child_of_two"))) {
    out[0] = fault_is("child_cycle") ? 0 : 2;
    return 1;
  }
  if (node != 0) return 0;
  if (fault_is("many_children")) return UINT32_MAX;
  for (uint32_t i = 0; i < t->count && i < capacity; ++i) out[i] = i + 1;
  if (fault_is("another_tree")) // neighbours change places by the bits of the process's number
    for (uint32_t i = 0; (i | 1) < t->count; ++i)
      out[i] = (i ^ ((uint32_t)getpid() >> (i / 2) & 1)) + 1;
  if (fault_is("child_beyond")) out[0] = 1000000;
  return t->count;
}

static uint32_t lights(void* of, uint32_t node, uint32_t* out, uint32_t capacity) {
  const tree* t = of;
  (void)capacity;
  if (fault_is("many_lights")) return UINT32_MAX - 1;
  if (fault_is("light_left_out") && node == 1) return 0;
  out[0] = fault_is("light_beyond") ? t->count : node - 1;
  return 1;
}

static int representative(void* of, uint32_t node, uint32_t* light) {
  const tree* t = of;
  *light = node % t->count;
  return 0;
}

static int bound(void* of, uint32_t node, const lightcuts_point* point, float out[3]) {
  (void)of;
  (void)node;
  (void)point;
  if (fault_is("hang_in_bound") && fork() == 0) hang();
  misbehave_in("bound");
  if (fault_is("code_in_bound")) return 42;
  if (fault_is("nothing_written")) return 0;
  for (int c = 0; c < 3; ++c) out[c] = INFINITY;
  if (fault_is("nan_bound")) out[1] = NAN;
  static float next = 1e30F;
  if (fault_is("spoils_arithmetic")) out[0] = arithmetic_is_usual() ? 1 : 0;
  if (fault_is("counts_builds")) out[0] = (float)builds;
  if (fault_is("random_bound")) out[0] = next *= 1.0001F;
  return 0;
}

static int estimate(void* of, uint32_t node, const lightcuts_point* point, const float limit[3],
                    double out[3]) {
  (void)of;
  (void)node;
  (void)point;
  (void)limit;
  misbehave_in("estimate");
  for (int c = 0; c < 3; ++c) out[c] = 0;
  if (fault_is("nan_estimate")) out[2] = NAN;
  return 0;
}

/// Every light, taken for black; nothing certified.
static int select_cut(void* of, const lightcuts_point* point, const lightcuts_cut_config* config,
                      const lightcuts_visibility* visibility, lightcuts_cut* cut) {
  const tree* t = of;
  (void)point;
  (void)config;
  misbehave_in("select");
  visibility->visible(visibility->context, fault_is("asks_beyond") ? t->count : 0);
  for (int c = 0; c < 3; ++c) {
    cut->radiance[c] = 0;
    cut->certified_error[c] = INFINITY;
  }
  if (fault_is("nan_radiance")) cut->radiance[0] = NAN;
  cut->end = fault_is("no_such_end") ? 77 : LIGHTCUTS_END_CONVERGED;
  cut->size = fault_is("many_clusters") ? UINT32_MAX : t->count;
  for (uint32_t i = 0; i < t->count; ++i) {
    cut->clusters[i].node = i + 1;
    for (int c = 0; c < 3; ++c) cut->clusters[i].estimate[c] = 0;
  }
  if (fault_is("cut_node_beyond")) cut->clusters[0].node = 123456789;
  if (fault_is("cut_node_twice")) cut->clusters[0].node = t->count;
  return 0;
}

static int probability(void* of, uint32_t node, const lightcuts_point* point, uint32_t light,
                       double* out) {
  const tree* t = of;
  (void)point;
  (void)light;
  *out = node == 0 ? 1.0 / t->count : 1;
  if (fault_is("nan_probability")) *out = NAN;
  return 0;
}

static int sample(void* of, uint32_t node, const lightcuts_point* point, double u, uint32_t* light,
                  double* out) {
  const tree* t = of;
  misbehave_in("sample");
  if (fault_is("code_in_sample")) return -7;
  *light = node == 0 ? (uint32_t)(u * t->count) : node - 1;
  if (fault_is("draws_beyond")) *light = UINT32_MAX - 1;
  return probability(of, node, point, *light, out);
}

/// Leaves out what FAULT does not want judged.
static void leave_out(lightcuts_subject* s) {
  const int is_cut = strstr(FAULT, "cut") != NULL || strstr(FAULT, "select") != NULL;
  if (!is_cut && !fault_is("nan_radiance") && !fault_is("many_clusters") &&
      !fault_is("no_such_end") && !fault_is("asks_beyond"))
    s->select = NULL;
  if (!fault_is("wrong_representative")) s->representative = NULL;
  if (!fault_begins("only")) return;
  if (!fault_is("only_bounds")) s->bound = NULL;
  if (fault_is("only_bounds") || fault_is("only_cuts")) {
    s->estimate = NULL;
    s->probability = NULL;
  }
  if (!fault_is("only_sampling")) s->sample = NULL;
}

const lightcuts_subject* lightcuts_subject_v1(void) {
  static struct {
    lightcuts_subject v1;
    void (*more[4])(void);
  } s;
  if (fault_is("no_table")) return NULL;
  s.v1.abi_version = fault_is("wrong_version") ? 99 : LIGHTCUTS_SUBJECT_ABI_VERSION;
  s.v1.size = fault_is("small_table") ? 16 : fault_is("newer_table") ? sizeof s : sizeof s.v1;
  s.v1.build = build;
  s.v1.destroy = destroy;
  s.v1.node_count = node_count;
  s.v1.children = fault_is("no_function") ? NULL : children;
  s.v1.lights = lights;
  s.v1.representative = representative;
  s.v1.bound = bound;
  s.v1.estimate = estimate;
  s.v1.select = select_cut;
  s.v1.sample = sample;
  s.v1.probability = probability;
  leave_out(&s.v1);
  return &s.v1;
}
