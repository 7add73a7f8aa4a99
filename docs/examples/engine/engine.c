/* The same engine in C: bodies that fall freely. */
#include <cylon/engine.h>

#include <stdlib.h>
#include <string.h>

typedef struct world {
  const cylon_scene* scene;
  cylon_state* state;
  double dt;
} world;

static const char* load(void* self, const cylon_scene* scene, double dt) {
  world* w = self;
  free(w->state);
  w->scene = scene, w->dt = dt;
  w->state = calloc(scene->bodies, sizeof *w->state);
  if (!w->state) return "no memory";
  for (size_t i = 0; i < scene->bodies; ++i) w->state[i] = scene->body[i].initial;
  return NULL;
}

/* x += v dt + a dt^2/2;  v += a dt */
static void step(void* self) {
  world* w = self;
  for (size_t i = 0; i < w->scene->bodies; ++i) {
    const cylon_body* body = &w->scene->body[i];
    cylon_state* s = &w->state[i];
    for (int k = 0; k < 3 && !body->locked; ++k) {
      s->position[k] += s->velocity[k] * w->dt + body->gravity[k] * w->dt * w->dt / 2;
      s->velocity[k] += body->gravity[k] * w->dt;
    }
  }
}

static void read(void* self, cylon_state* states) {
  const world* w = self;
  memcpy(states, w->state, w->scene->bodies * sizeof *states);
}

int main(void) {
  static world w;
  static const cylon_engine engine = {.version = CYLON_ENGINE_VERSION,
                                      .name = "my-engine-c",
                                      .engine_version = "1.0",
                                      .precision = "double",
                                      .integrator = "verlet",
                                      .order = 2,
                                      .conserves = "energy",
                                      .self = &w,
                                      .load = load,
                                      .step = step,
                                      .read = read};
  return cylon_worker_main(&engine);
}
