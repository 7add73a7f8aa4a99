// Rapier's deterministic build, which npm has as a package of its own: the adapter is that of Rapier.  Its features:
// builds/prepare_builds/assets/dim3_deterministic.json of dimforge/rapier.js.
import * as rapier from './rapier.mjs';

export const about = {
  ...rapier.about, name: 'rapier-deterministic',
  of_the_scene: [
    {name: 'features of the Rust crate', value: 'with enhanced-determinism', engine_default: 'without',
      reason: '@dimforge/rapier3d-deterministic-compat is built so; nothing else differs from rapier'},
    ...rapier.about.of_the_scene,
  ],
};

export const start = () => rapier.start('@dimforge/rapier3d-deterministic-compat');
