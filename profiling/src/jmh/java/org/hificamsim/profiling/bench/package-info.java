/** Benchmarks of the fidelity ladder. */
package org.hificamsim.profiling.bench;
