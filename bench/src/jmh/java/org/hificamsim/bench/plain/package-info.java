/**
 * The simulation as a researcher would first write it in Java, with an object for each thing and a
 * loop over all pairs. The benchmarks compare the engine with it; it is neither tuned nor slowed
 * down.
 */
package org.hificamsim.bench.plain;
