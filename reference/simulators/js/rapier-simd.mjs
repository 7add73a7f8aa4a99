// Rapier's build with SIMD, which npm has as a package of its own and of an earlier version: the adapter is that of Rapier.
// Its features: builds/prepare_builds/assets/dim3_simd.json of dimforge/rapier.js.
import * as rapier from './rapier.mjs';

export const about = {
  ...rapier.about, name: 'rapier-simd',
  of_the_scene: [
    {name: 'features of the Rust crate', value: 'with simd-stable', engine_default: 'without',
      reason: '@dimforge/rapier3d-simd-compat is built so, and all of it for simd128'},
    ...rapier.about.of_the_scene,
  ],
};

export const start = () => rapier.start('@dimforge/rapier3d-simd-compat');
