/* A force of your own: a shared library that `--plugin NAME=FILE` lets take part, and whose laws a scenario names in
   [[plugin_force]] (docs/in-house.md#forces-of-your-own).  Nothing of C++ crosses: plain structures and one function,
   cylon_plugin.  C99 and C++.

   SI units; right-handed axes; y up.  Quaternions are (w, x, y, z), from body axes to world axes.  Matrices are row by row. */
#ifndef CYLON_FORCE_H
#define CYLON_FORCE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this header.  It moves with every change that a compiled plug-in would see (docs/library.md). */
#define CYLON_FORCE_VERSION 1

/* A body on which the force acts.  In a frame that turns, all is as the frame sees it; a law that does not say that it reads
   velocities may find inertial ones there. */
typedef struct cylon_seen_body {
  double mass;                /* Now [kg]. */
  double inertia[9];          /* About the centre of mass, body axes [kg m^2]. */
  double position[3];         /* Centre of mass [m]. */
  double orientation[4];      /* w, x, y, z; unit. */
  double velocity[3];         /* Of the centre of mass [m/s]. */
  double angular_velocity[3]; /* World axes [rad/s]. */
} cylon_seen_body;

/* What acts on a body, world axes. */
typedef struct cylon_load {
  double force[3];  /* At the centre of mass [N]. */
  double torque[3]; /* About the centre of mass [N m]. */
} cylon_load;

/* A number that the scenario may state. */
typedef struct cylon_law_parameter {
  const char* name;
  double least, most; /* Of the value; it is finite. */
  double absent;      /* The value where none is stated; NaN: it must be stated. */
} cylon_law_parameter;

/* A kind of force. */
typedef struct cylon_law {
  const char* name;                 /* As in the scenario. */
  size_t least_bodies, most_bodies; /* How many it acts on; most_bodies = 0: as many as are named. */
  int reads_velocities;             /* Not 0: the force depends on a velocity or an angular velocity. */
  int reads_time;                   /* Not 0: it depends on the time. */
  size_t parameters;                /* How many. */
  const cylon_law_parameter* parameter;

  /* Why the law does not take these parameters and this start, or NULL: takes all.  Returns NULL where it takes them; the
     text lives until the next call. */
  const char* (*refuses)(const double* parameters, const cylon_seen_body* bodies, size_t count);

  /* Adds to the loads, one for each body and zero before.  A function of its arguments alone: engines ask for trial states,
     for times in any order, and for several solutions side by side.  What is not finite ends the run. */
  void (*apply)(const double* parameters, double time, const cylon_seen_body* bodies, size_t count,
                cylon_load* loads);
} cylon_law;

/* Texts are UTF-8.  All of it lives as long as the library is loaded. */
typedef struct cylon_plugin_table {
  uint32_t version; /* CYLON_FORCE_VERSION. */
  size_t laws;      /* How many. */
  const cylon_law* law;
} cylon_plugin_table;

/* The one function that the library shows. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const cylon_plugin_table*
cylon_plugin(void);

#ifdef __cplusplus
}
#endif

#endif
