/** Benchmarks of the step (JMH). */
package org.hificamsim.bench;
