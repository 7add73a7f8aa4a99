// The surface of water as a mesh: a sheet that waves, or the table of cells of mode "step".
import { BufferAttribute, BufferGeometry, Mesh } from 'three';
import type { RawShaderMaterial } from 'three';

import { cellsOfWater, sheetOfWater } from './water';
import type { Bounds } from './types';
import type { Scene } from '../documents';

export function waterMesh(water: Scene['water'][number], bounds: Bounds, material: RawShaderMaterial): Mesh {
  const geometry = new BufferGeometry();
  const { place, index } = water.mode === 'step' ? cellsOfWater() : sheetOfWater(bounds, 80);
  geometry.setAttribute('place', new BufferAttribute(place, 4));
  geometry.setIndex(new BufferAttribute(index, 1));
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = mesh.matrixAutoUpdate = false;
  return mesh;
}
