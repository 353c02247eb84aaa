// What the policies of a comparison are measured by.

export const OPTIMAL = 'optimal';

/** The names in place of a policy's that no network of cameras can run. */
export const YARDSTICKS = [OPTIMAL, 'best-fixed', 'bound', 'reachable'];
