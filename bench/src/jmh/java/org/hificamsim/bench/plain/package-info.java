/**
 * The peer of the benchmarks: the simulation as a researcher would first write it in Java, with an
 * object for each thing and a loop over all pairs. Neither tuned nor slowed down.
 */
package org.hificamsim.bench.plain;
