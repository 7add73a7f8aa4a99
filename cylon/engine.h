/* An engine in C as a table of functions; cylon_worker_main makes of it a worker for `cylon run --worker`
   (docs/library.md).  C99 and C++.

   SI units; right-handed axes; y up.  Quaternions are (w, x, y, z), unit, from body axes to world axes.  Velocities are
   those of the centre of mass, angular velocities in world axes.  The origin of body axes is the centre of mass.  Matrices
   are row by row.  Bodies, planes and so on are named by their index from 0. */
#ifndef CYLON_ENGINE_H
#define CYLON_ENGINE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this header.  It moves with every change that a compiled engine would see (docs/library.md). */
#define CYLON_ENGINE_VERSION 1

/* The other end of a spring, a joint or a pair that is no body. */
#define CYLON_WORLD (-1)

/* What an engine takes, or-ed in cylon_engine::takes.  A scene with anything else is refused for it. */
enum cylon_part {
  CYLON_ROTATION = 1, /* Bodies that spin, or that a joint, an anchor or a contact may turn. */
  CYLON_CONTACTS = 2, /* Pairs that may touch. */
  CYLON_SPRINGS = 4,
  CYLON_DRAGS = 8,
  CYLON_DRIVES = 16,
  CYLON_ATTRACTIONS = 32,
  CYLON_JOINTS = 64
};

enum cylon_shape {
  CYLON_NO_SHAPE,
  CYLON_SPHERE,   /* size: radius */
  CYLON_BOX,      /* size: half the edges along body x, y, z */
  CYLON_CAPSULE,  /* size: radius, length of the cylindrical part; along body y */
  CYLON_CYLINDER, /* size: radius, length; along body y */
  CYLON_CONE      /* size: radius, length; tip towards +y, centre of mass length/4 above the base */
};

enum cylon_joint_kind { CYLON_BALL, CYLON_HINGE, CYLON_DISTANCE, CYLON_FIXED };

typedef struct cylon_state {
  double position[3];         /* Centre of mass [m]. */
  double orientation[4];      /* w, x, y, z. */
  double velocity[3];         /* [m/s] */
  double angular_velocity[3]; /* World axes [rad/s]. */
} cylon_state;

typedef struct cylon_body {
  const char* name;
  double mass;       /* [kg], > 0 */
  double inertia[9]; /* About the centre of mass, body axes [kg m^2]. */
  double gravity[3]; /* What makes it fall: its own, else that of the scene [m/s^2]. */
  cylon_state initial;
  int locked;             /* It does not move, whatever acts on it. */
  enum cylon_shape shape; /* Of a body in some pair; else CYLON_NO_SHAPE. */
  double size[3];         /* [m] */
} cylon_body;

/* F = (stiffness (|d| - rest_length) + damping d(|d|)/dt) d/|d| on `body`, -F on `to`, with d from the anchor on `body` to
   the anchor on `to`; zero at d = 0. */
typedef struct cylon_spring {
  int body, to;        /* to: a body or CYLON_WORLD. */
  double anchor[3];    /* Body axes [m]. */
  double to_anchor[3]; /* Axes of `to`; of the world where that is the world [m]. */
  double stiffness;    /* [N/m] */
  double rest_length;  /* [m] */
  double damping;      /* [N s/m] */
} cylon_spring;

/* F = -linear v; torque = -angular w - momentum L, with L the spin angular momentum. */
typedef struct cylon_drag {
  int body;
  double linear;   /* [kg/s] */
  double angular;  /* [kg m^2/s] */
  double momentum; /* [1/s] */
} cylon_drag;

/* F = force cos(frequency t) at the centre of mass, world axes. */
typedef struct cylon_drive {
  int body;
  double force[3];  /* [N] */
  double frequency; /* [rad/s] */
} cylon_drive;

/* F = strength m m' d/|d|^3 on `body`, -F on `to`, with d from `body` to `to`. */
typedef struct cylon_attraction {
  int body, to;
  double strength; /* [m^3/(kg s^2)] */
} cylon_attraction;

typedef struct cylon_joint {
  enum cylon_joint_kind kind;
  int body, to;    /* to: a body or CYLON_WORLD. */
  double point[3]; /* World, at t = 0 [m]; a distance joint of two bodies joins their centres and has none. */
  double axis[3];  /* Of a hinge; world axes at t = 0, unit. */
  double length;   /* Of a distance joint [m]. */
} cylon_joint;

/* Solid where normal . x < offset. */
typedef struct cylon_plane {
  const char* name;
  double normal[3]; /* Unit, world axes. */
  double offset;    /* [m] */
} cylon_plane;

/* Two bodies (plane = CYLON_WORLD), or a body and a plane (other = CYLON_WORLD), that may touch; no others may. */
typedef struct cylon_pair {
  int body, other, plane;
  double restitution; /* Of the pair, [0, 1]. */
  double friction;    /* Of the pair, Coulomb's coefficient, static and kinetic, >= 0. */
} cylon_pair;

typedef struct cylon_scene {
  size_t bodies, springs, drags, drives, attractions, joints, planes, pairs; /* How many. */
  const cylon_body* body;
  const cylon_spring* spring;
  const cylon_drag* drag;
  const cylon_drive* drive;
  const cylon_attraction* attraction;
  const cylon_joint* joint;
  const cylon_plane* plane;
  const cylon_pair* pair;
  int simultaneous_impacts; /* 1: impacts at one instant resolve together; 0: one after another. */
} cylon_scene;

/* Texts end in a zero and are UTF-8.  Texts and table outlive cylon_worker_main. */
typedef struct cylon_engine {
  uint32_t version;           /* CYLON_ENGINE_VERSION. */
  uint32_t takes;             /* Of cylon_part. */
  const char* name;           /* "my-engine" */
  const char* engine_version; /* "1.0" */
  const char* precision;      /* "double" or "float": of the engine's own state. */
  const char* integrator;     /* Its name, for reports. */
  int order;                  /* Of the global error in smooth motion, >= 1. */
  const char* conserves;      /* In words; NULL: nothing in particular. */
  void* self;                 /* Handed to each function. */

  /* Starts over from the scene's initial state, with the step dt [s], > 0.  Returns NULL, or why the engine cannot express
     the scene; the text lives until the next call.  The scene lives until the next load. */
  const char* (*load)(void* self, const cylon_scene* scene, double dt);
  /* Advances by exactly one dt. */
  void (*step)(void* self);
  /* Writes the motion, read from the engine's own state, into one cylon_state for each body of the scene. */
  void (*read)(void* self, cylon_state* states);
} cylon_engine;

/* Serves the protocol on stdin and stdout until quit or the end of input, and returns what main returns: 0; 1 when nobody
   listens any more; 2, with a sentence on stderr, for a table that cannot be.  What the engine prints on stdout goes to
   stderr. */
int cylon_worker_main(const cylon_engine* engine);

#ifdef __cplusplus
}
#endif

#endif
