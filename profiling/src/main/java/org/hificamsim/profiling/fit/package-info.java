/** Regressions: feature abstractions f, detector lines g, and how well they fit. */
package org.hificamsim.profiling.fit;
