/** Benchmarks of the step (JMH). */
package org.hificamsim.experiments.bench;
