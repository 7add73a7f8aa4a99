// What of a scene may be changed while it runs: keys as the server knows them, words and units for people.
import type { Scene, Vector } from '../shared/documents';

export interface Parameter {
  key: string; // "spring.0.stiffness"
  group: string; // "spring a – b"
  label: string;
  unit: string;
  value: number | Vector;
  least: number; // of a number
  most: number;
}

interface Column {
  name: string;
  label: string;
  unit: string;
  least?: number;
  most?: number;
}

type Row = Record<string, unknown>;
const text = (row: Row, name: string): string => (typeof row[name] === 'string' ? (row[name] as string) : '');
const between = (row: Row): string => (Array.isArray(row.between) ? row.between.join(' – ') : '');

/** The lists of a scene whose elements have numbers to change. */
const lists: { list: string; title: (row: Row) => string; columns: Column[] }[] = [
  {
    list: 'spring',
    title: (row) => `spring ${text(row, 'body')} – ${text(row, 'to') || 'pin'}`,
    columns: [
      { name: 'stiffness', label: 'stiffness', unit: 'N/m', least: 0 },
      { name: 'rest_length', label: 'rest length', unit: 'm', least: 0 },
      { name: 'damping', label: 'damping', unit: 'N s/m', least: 0 },
    ],
  },
  {
    list: 'drag',
    title: (row) => `drag of ${text(row, 'body')}`,
    columns: [
      { name: 'linear', label: 'linear', unit: 'kg/s', least: 0 },
      { name: 'angular', label: 'angular', unit: 'kg m²/s', least: 0 },
      { name: 'momentum', label: 'momentum', unit: '1/s', least: 0 },
    ],
  },
  {
    list: 'attraction',
    title: (row) => `attraction ${text(row, 'body')} – ${text(row, 'to')}`,
    columns: [{ name: 'strength', label: 'strength', unit: 'm³/(kg s²)' }],
  },
  {
    list: 'water',
    title: () => 'water',
    columns: [
      { name: 'level', label: 'level', unit: 'm' },
      { name: 'buoyancy', label: 'buoyancy', unit: '', least: 0 },
      { name: 'drag', label: 'drag', unit: 'kg/s', least: 0 },
    ],
  },
  {
    list: 'material',
    title: (row) => `contact ${between(row)}`,
    columns: [
      { name: 'restitution', label: 'restitution', unit: '', least: 0, most: 1 },
      { name: 'friction', label: 'friction', unit: '', least: 0 },
    ],
  },
];

export function parametersOf(scene: Scene): Parameter[] {
  const found: Parameter[] = [
    {
      key: 'gravity',
      group: 'gravity',
      label: 'gravity',
      unit: 'm/s²',
      value: scene.gravity,
      least: -Infinity,
      most: Infinity,
    },
  ];
  for (const { list, title, columns } of lists) {
    const rows = Array.isArray(scene[list]) ? (scene[list] as Row[]) : [];
    rows.forEach((row, index) => {
      for (const { name, label, unit, least = -Infinity, most = Infinity } of columns)
        if (typeof row[name] === 'number')
          found.push({
            key: `${list}.${index}.${name}`,
            group: title(row),
            label,
            unit,
            value: row[name],
            least,
            most,
          });
    });
  }
  for (const body of scene.body)
    if (!body.locked)
      found.push({
        key: `body.${body.name}.mass`,
        group: 'masses',
        label: body.name,
        unit: 'kg',
        value: body.mass,
        least: Number.MIN_VALUE,
        most: Infinity,
      });
  return found;
}

/** What somebody typed, or why it is no value for this parameter. */
export function readValue(parameter: Parameter, typed: string): { value: number } | { error: string } {
  const value = Number(typed.trim());
  if (typed.trim() === '' || !Number.isFinite(value)) return { error: 'a number, please' };
  if (value < parameter.least || value > parameter.most)
    return {
      error:
        parameter.most === Infinity
          ? `must be at least ${parameter.least === Number.MIN_VALUE ? 'above 0' : parameter.least}`
          : `must lie in ${parameter.least} … ${parameter.most}`,
    };
  return { value };
}

/** What of a scene one can see: pictures are made anew when this changes, and not for every stiffness. */
export function seen(scene: Scene): string {
  return JSON.stringify([
    scene.body.map((b) => [b.name, b.shape, b.color, b.locked, b.position, b.orientation]),
    scene.joint,
    scene.spring.map((s) => [s.body, s.anchor, s.to, s.to_anchor, s.pin]),
    scene.plane,
    scene.water,
  ]);
}
