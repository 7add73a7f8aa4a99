// The methods of the engine, what each supports, and what a model asks of them.  A method gets a model only
// if it supports all that the model asks; the tables say what a method can do, never what it cannot.
#pragma once

#include "engine/features.h"
#include "engine/model.h"

#include <string>

namespace cylon::engine {

struct Options;

/// How a model, or a part of the work on it, is carried through time.
enum class Method {
  exact,         ///< FreeStepper
  free,          ///< FreeBodies
  modes,         ///< ModesStepper
  points,        ///< Points, by an integrator
  top,           ///< Top, by an integrator
  bodies,        ///< Bodies, by an integrator
  trees,         ///< Trees, by an integrator
  ballistic,     ///< Ballistic
  events,        ///< EventStepper
  sphere_steps,  ///< pile::SpherePile
  body_steps,    ///< pile::BodyPile
  count
};

/// What a method supports.
Features supports(Method);

/// What a model asks of its method.
Features required(const Model&);
/// The same with what is asked of the run.
Features required(const Model&, const Options&);

/// What a model asks for and a method does not support, in words; empty where it supports all.
std::string missing(Method, const Model&);

/// Whether anything in the model can touch.
bool can_touch(const Model&);

}  // namespace cylon::engine
