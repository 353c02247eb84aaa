/** Coverage metrics of a step and of a run (section 7.1). */
package org.hificamsim.core.metrics;
