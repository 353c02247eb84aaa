/** Photos set up again in the simulator: whether it detects what was measured. */
package org.hificamsim.profiling.trial;
