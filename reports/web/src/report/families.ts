// Which columns belong together: the builds and variants of one engine are a family.

/** The engine without its variant and its precision: "bullet-multibody" of "bullet-multibody-float/gyro=none". */
function base(engine: string): string {
  return engine.split('/')[0]!.replace(/(?<=.)-float$/, '');
}

/** The family of each engine, from the version that each says ("": it says none).  An engine joins another of the same
 * version whose name its own continues after a '-': bullet-multibody joins bullet. */
export function families(versions: Map<string, string>): Map<string, string> {
  const versionOf = new Map<string, string>(); // of bases
  for (const [engine, version] of versions)
    versionOf.set(base(engine), versionOf.get(base(engine)) || version);
  const shortestFirst = [...versionOf.keys()].sort((a, b) => a.length - b.length);
  const familyOf = (name: string) =>
    shortestFirst.find((a) => name.startsWith(`${a}-`) && versionOf.get(a) === versionOf.get(name)) ?? name;
  return new Map([...versions.keys()].map((engine) => [engine, familyOf(base(engine))]));
}

export interface Family {
  name: string;
  columns: number[]; // indices, in the order of the columns
}

/** Families in order of first appearance, each with those of its columns that are `shown`. */
export function grouped(columns: { family: string }[], shown: boolean[]): Family[] {
  const out = new Map<string, number[]>();
  columns.forEach(({ family }, j) => {
    const group = out.get(family) ?? [];
    out.set(family, group);
    if (shown[j]) group.push(j);
  });
  return [...out].flatMap(([name, group]) => (group.length > 0 ? [{ name, columns: group }] : []));
}

/** Whether a header row of families helps: several have several columns, or there are more columns than fit a glance. */
export function hasFamilyRow(shown: Family[]): boolean {
  const several = shown.filter(({ columns }) => columns.length > 1).length;
  const total = shown.reduce((n, { columns }) => n + columns.length, 0);
  return several > 1 || total > 6;
}
