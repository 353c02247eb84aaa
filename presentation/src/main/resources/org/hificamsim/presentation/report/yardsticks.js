// The yardsticks that policies of a comparison are measured by.

export const OPTIMAL = 'optimal';

/** The yardsticks' names, as they stand among the policies in tables. */
export const YARDSTICKS = [OPTIMAL, 'best-fixed', 'bound', 'reachable'];
