/**
 * Ways: the most that cameras can score when their moves take time and everything is known in
 * advance, as a plan of all ways and a bound. Begin with {@link
 * org.hificamsim.solver.way.WaySolver}.
 */
package org.hificamsim.solver.way;
