// A step with the parts that an engine makes of it (harness/results/substeps.h).

/** "16 ms (4 substeps)"; the step alone where it has one part; without a step "4 substeps". */
export function withSubsteps(step: string, substeps: number | undefined): string {
  if ((substeps ?? 1) === 1) return step;
  return step ? `${step} (${substeps} substeps)` : `${substeps} substeps`;
}
