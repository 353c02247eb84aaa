/** JMH benchmarks, and programs that make their instances and draw their results. */
package org.hificamsim.bench;
