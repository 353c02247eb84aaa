/** Generators of random scenarios, and of the layouts of sites in the benchmark. */
package org.hificamsim.runs.generate;
